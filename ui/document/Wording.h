#pragma once

#include <QString>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/Error.h"

namespace vestige {

/// How numbers and names are written in the window; numbers always with '.', a minus sign for negative ones.

QString toQt(std::string_view text);
inline QString toQt(const std::string& text) {
    return QString::fromStdString(text);
}
QString toQt(const std::filesystem::path& path);
/// What core says (a message, a reason, a note, an edit's text), in the language of the window.
QString said(std::string_view english);
/// The same as a sentence of its own, with its full stop.
QString saidSentence(std::string_view english);
QString saidSentence(const Error& error);
std::filesystem::path toPath(const QString& path);

/// "4.786": metres with three decimals, four below 0.1 m; an en dash for nothing.
QString lengthText(std::optional<double> metres);
/// "0.014": an uncertainty in metres, with the digits of core/measurement/MeasuredText.h.
QString uncertaintyText(std::optional<double> metres);
/// "+0.04": a relative error as percent, with its sign, two decimals (one from 10 % on).
QString percentText(std::optional<double> fraction);
/// "0.0427": a fraction with four decimals.
QString fractionText(std::optional<double> fraction);
/// "14.8 mm" below 0.1 m, else "1.480 m".
QString distanceText(double metres);
/// "5.0 M", "12.3 k", "870".
QString countText(std::uint64_t count);
/// "2nd", "11th": a place in a row.
QString ordinalText(std::uint64_t place);
/// "E 483 400.579  N 4 375 661.706  H 34.825 m" for large coordinates, "x 1.250  y -0.310  z 0.840 m" else.
QString coordinateText(double x, double y, double z);

}  // namespace vestige
