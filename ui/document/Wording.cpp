#include "ui/document/Wording.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/measurement/MeasuredText.h"

namespace vestige {
namespace {

const QString kNothing = QString::fromUtf8("–");
const QString kMinus = QString::fromUtf8("−");

QString number(double value, int decimals) {
    QString text = toQt(fixedText(value, decimals));
    if (text.startsWith('-')) text.replace(0, 1, kMinus);
    return text;
}

/// Thousands set off by a narrow space.
QString grouped(double value, int decimals) {
    QString text = number(value, decimals);
    const int first = text.startsWith(kMinus) ? 1 : 0;
    int point = text.indexOf('.');
    if (point < 0) point = text.size();
    for (int i = point - 3; i > first; i -= 3) text.insert(i, QChar(0x2009));
    return text;
}

}  // namespace

QString toQt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString said(std::string_view english) {
    return QString::fromStdString(say(english));
}

QString saidSentence(std::string_view english) {
    return QObject::tr("%1.", "a sentence that core says").arg(said(english));
}

QString saidSentence(const Error& error) {
    return QObject::tr("%1.", "a sentence that core says").arg(QString::fromStdString(say(error)));
}

QString toQt(const std::filesystem::path& path) {
    return QString::fromStdString(path.string());
}

std::filesystem::path toPath(const QString& path) {
    return std::filesystem::path(path.toStdString());
}

QString lengthText(std::optional<double> metres) {
    if (!metres) return kNothing;
    return number(*metres, std::abs(*metres) < 0.1 ? 4 : 3);
}

QString uncertaintyText(std::optional<double> metres) {
    if (!metres || !std::isfinite(*metres)) return kNothing;
    if (*metres <= 0) return "0";
    return toQt(measuredText(0, metres).uncertainty);
}

QString percentText(std::optional<double> fraction) {
    if (!fraction) return kNothing;
    const double percent = 100 * *fraction;
    const QString text = number(percent, std::abs(percent) >= 10 ? 1 : 2);
    return percent > 0 ? "+" + text : text;
}

QString fractionText(std::optional<double> fraction) {
    return fraction ? number(*fraction, 4) : kNothing;
}

QString distanceText(double metres) {
    return std::abs(metres) < 0.1 ? number(1000 * metres, 1) + " mm" : number(metres, 3) + " m";
}

QString countText(std::uint64_t count) {
    if (language() == Language::simplifiedChinese) {  // counts by ten thousands and their squares
        if (count >= 100000000) return number(static_cast<double>(count) / 1e8, 2) + QStringLiteral(" 亿");
        if (count >= 10000) return number(static_cast<double>(count) / 1e4, 1) + QStringLiteral(" 万");
        return QString::number(count);
    }
    if (count >= 1000000) return number(static_cast<double>(count) / 1e6, 1) + " M";
    if (count >= 10000) return number(static_cast<double>(count) / 1e3, 1) + " k";
    return QString::number(count);
}

QString coordinateText(double x, double y, double z) {
    const bool survey = std::max(std::abs(x), std::abs(y)) >= 10000;
    return QString(survey ? "E %1   N %2   H %3 m" : "x %1   y %2   z %3 m")
        .arg(grouped(x, 3), grouped(y, 3), grouped(z, 3));
}

QString ordinalText(std::uint64_t place) {
    if (language() != Language::english) return QString::number(place);
    const bool teen = place % 100 / 10 == 1;
    const char* ending = teen              ? "th"
                         : place % 10 == 1 ? "st"
                         : place % 10 == 2 ? "nd"
                         : place % 10 == 3 ? "rd"
                                           : "th";
    return QString::number(place) + ending;
}

}  // namespace vestige
