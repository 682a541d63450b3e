#include "ui/panels/FitWords.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

/// Two-sided 95 % of a normal distribution.
constexpr double k95 = 1.959963985;
/// Beyond these a figure says no more than that nothing holds the pose.
constexpr double kMost_m = 10;
constexpr double kMost_deg = 90;

/// "(± 39 mm)" of a direction.
QString reachText(double sigma_m) {
    const double reach = k95 * sigma_m;
    if (!(reach <= kMost_m)) return QObject::tr("(not held at all)");
    const int decimals =
        static_cast<int>(std::clamp(1 - std::floor(std::log10(std::max(reach, 1e-5))), 0.0, 5.0));
    return QString::fromUtf8("(± ") + (reach < 1
                                           ? toQt(fixedText(1000 * reach, std::max(0, decimals - 3))) + " mm)"
                                           : toQt(fixedText(reach, decimals)) + " m)");
}

QString capitalised(const std::string& sentence) {
    QString text = said(sentence);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

/// Of a covariance; nothing where it is not known.
QString limitText(double variance, double perUnit, const QString& unit, double most) {
    if (!std::isfinite(variance) || variance < 0) return QObject::tr("not known");
    const double value = perUnit * k95 * std::sqrt(variance);
    if (value > most) return QObject::tr("not held");
    const int decimals =
        value > 0 ? static_cast<int>(std::clamp(1 - std::floor(std::log10(value)), 0.0, 4.0)) : 0;
    return QString::fromUtf8("± ") + toQt(fixedText(value, decimals)) + unit;
}

QString lineOf(const QString& what, const PoseUncertainty& uncertainty, int first, double perUnit,
               const QString& unit, double most) {
    QString line = "<tr><td>" + what + "</td>";
    for (int axis = 0; axis < 3; ++axis)
        line += "<td align='right' style='padding-left: 14px'>" +
                limitText(uncertainty.covariance(first + axis, first + axis), perUnit, unit, most) + "</td>";
    return line + "</tr>";
}

}  // namespace

QString reasonsText(const RegistrationResult& result) {
    QStringList lines;
    for (const std::string& reason : result.reasons) lines << QString::fromUtf8("•  ") + capitalised(reason);
    return lines.join("\n");
}

std::vector<FiguresRow::Figure> residualFigures(const RegistrationResult& result) {
    std::vector<FiguresRow::Figure> figures{
        {toQt(fixedText(100 * result.overlap, 0)) + " %", QObject::tr("overlap"), {}},
        {distanceText(result.rmse_m), QObject::tr("RMS distance"), {}}};
    if (result.quality)
        figures.push_back({distanceText(result.quality->planeRmse_m), QObject::tr("RMS to planes"), {}});
    figures.push_back(
        {QString::number(result.iterations),
         result.converged ? QObject::tr("iterations, converged") : QObject::tr("iterations, not converged"),
         {}});
    return figures;
}

QString uncertaintyText(const PoseUncertainty& uncertainty) {
    return "<table><tr><td></td><td align='right'>x</td><td align='right'>y</td><td "
           "align='right'>z</td></tr>" +
           lineOf(QObject::tr("Position"), uncertainty, 0, 1000, " mm", 1000 * kMost_m) +
           lineOf(QObject::tr("Turn about"), uncertainty, 3, degrees(1), QString::fromUtf8("°"), kMost_deg) +
           "</table>";
}

bool leavesFree(const RegistrationQuality& quality) {
    return std::any_of(quality.directions.begin(), quality.directions.end(),
                       [](const ObservedDirection& direction) { return direction.free; });
}

QString freedomText(const RegistrationQuality& quality) {
    QStringList lines;
    for (const ObservedDirection& direction : quality.directions)
        if (direction.free)
            lines << QString::fromUtf8("•  ") + capitalised(direction.words) + " " +
                         reachText(direction.sigma_m);
    if (!lines.isEmpty()) return lines.join("\n");
    QString text = QObject::tr("Nothing: the data hold the pose in all six directions.");
    if (!quality.directions.empty() && !quality.directions.front().words.empty())
        text += "\n" + QObject::tr("Least held: %1 %2.")
                           .arg(said(quality.directions.front().words),
                                reachText(quality.directions.front().sigma_m));
    return text;
}

QString restartsText(const RestartSpread& restarts) {
    if (restarts.agreeing == 0)
        return QObject::tr("None of %1 restarts from perturbed poses came back to this place.")
            .arg(restarts.runs);
    constexpr double kLeast_m = 5e-5;
    const bool nowhere = restarts.translation_m < kLeast_m && degrees(restarts.rotation_rad) < 5e-4;
    return QObject::tr("%1 of %2 restarts from perturbed poses came back to this place, %3.")
        .arg(restarts.agreeing)
        .arg(restarts.runs)
        .arg(nowhere ? QObject::tr("within less than 0.1 mm and 0.001°")
                     : QObject::tr("within %1 and %2°")
                           .arg(distanceText(restarts.translation_m),
                                toQt(fixedText(degrees(restarts.rotation_rad), 3))));
}

QString candidateText(const RegistrationResult& result, std::size_t candidate) {
    if (candidate == 0) return QObject::tr("1: the best");
    const Similarity& best = result.candidates.front().targetFromSource;
    const Similarity& other = result.candidates[candidate].targetFromSource;
    const double apart = (other.pose.translation() - best.pose.translation()).norm();
    const double turn = rotationAngle(best.pose.linear().transpose() * other.pose.linear());
    return QObject::tr("%1: %2 and %3° from the best")
        .arg(candidate + 1)
        .arg(distanceText(apart), toQt(fixedText(degrees(turn), 0)));
}

}  // namespace vestige
