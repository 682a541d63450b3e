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

QString capitalised(const std::string& sentence) {
    QString text = QString::fromStdString(sentence);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

/// Of a covariance; nothing where it is not known.
QString limitText(double variance, double perUnit, const QString& unit) {
    if (!std::isfinite(variance) || variance < 0) return QObject::tr("not known");
    const double value = perUnit * k95 * std::sqrt(variance);
    const int decimals =
        value > 0 ? static_cast<int>(std::clamp(1 - std::floor(std::log10(value)), 0.0, 4.0)) : 0;
    return QString::fromUtf8("± ") + toQt(fixedText(value, decimals)) + unit;
}

QString lineOf(const QString& what, const PoseUncertainty& uncertainty, int first, double perUnit,
               const QString& unit) {
    QString line = "<tr><td>" + what + "</td>";
    for (int axis = 0; axis < 3; ++axis)
        line += "<td align='right' style='padding-left: 14px'>" +
                limitText(uncertainty.covariance(first + axis, first + axis), perUnit, unit) + "</td>";
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
           lineOf(QObject::tr("Position"), uncertainty, 0, 1000, " mm") +
           lineOf(QObject::tr("Turn about"), uncertainty, 3, degrees(1), QString::fromUtf8("°")) + "</table>";
}

bool leavesFree(const RegistrationQuality& quality) {
    return std::any_of(quality.directions.begin(), quality.directions.end(),
                       [](const ObservedDirection& direction) { return direction.free; });
}

QString freedomText(const RegistrationQuality& quality) {
    QStringList lines;
    for (const ObservedDirection& direction : quality.directions)
        if (direction.free)
            lines << QString::fromUtf8("•  ") + capitalised(direction.words) +
                         QObject::tr(" (± %1)").arg(distanceText(k95 * direction.sigma_m));
    if (!lines.isEmpty()) return lines.join("\n");
    QString text = QObject::tr("Nothing: the data hold the pose in all six directions.");
    if (!quality.directions.empty() && !quality.directions.front().words.empty())
        text += "\n" + QObject::tr("Least held: %1 (± %2).")
                           .arg(QString::fromStdString(quality.directions.front().words),
                                distanceText(k95 * quality.directions.front().sigma_m));
    return text;
}

QString restartsText(const RestartSpread& restarts) {
    return QObject::tr("%1 of %2 restarts from perturbed poses came to the same place, within %3 and %4°.")
        .arg(restarts.agreeing)
        .arg(restarts.runs)
        .arg(distanceText(restarts.translation_m), toQt(fixedText(degrees(restarts.rotation_rad), 3)));
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
