#pragma once

#include <QString>
#include <vector>

#include "core/registration/RegistrationResult.h"
#include "ui/panels/FiguresRow.h"

namespace vestige {

/// How a registration's quality is put into words.

/// The verdict's reasons, one line each.
QString reasonsText(const RegistrationResult& result);
/// Overlap, RMS distances, whether it converged.
std::vector<FiguresRow::Figure> residualFigures(const RegistrationResult& result);
/// Position and turn along and about x, y, z with their 95 % limits.
QString uncertaintyText(const PoseUncertainty& uncertainty);
bool leavesFree(const RegistrationQuality& quality);
/// The free directions, one line each with their standard deviation; else the least held one.
QString freedomText(const RegistrationQuality& quality);
QString restartsText(const RestartSpread& restarts);
/// "1: the best", "2: 3.214 m and 178° from the best".
QString candidateText(const RegistrationResult& result, std::size_t candidate);

}  // namespace vestige
