#pragma once

#include <QString>

namespace vestige {

/// Where a finished sample case lies: the user's own, else the one beside the program's build. Empty where
/// there is none.
QString sampleCase();

/// The folder that the user's own sample case is simulated into.
QString sampleFolder();

/// Marks the folder as whole, once everything is written.
QString sampleMark(const QString& folder);

}  // namespace vestige
