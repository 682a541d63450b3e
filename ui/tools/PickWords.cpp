#include "ui/tools/PickWords.h"

#include <Eigen/Eigenvalues>
#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/measurement/Length.h"
#include "core/report/QuantityText.h"
#include "core/scene/MeasuredScene.h"
#include "ui/document/PickChoices.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

double worstDeviation(const FittedFeature& feature) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(feature.covariance, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

QString signedMillimetres(double metres) {
    const QString text = millimetreText(std::abs(metres));
    return (metres < 0 ? QString(QChar(0x2212)) : QString('+')) + text;
}

}  // namespace

QString millimetreText(double metres) {
    const double value = 1000 * metres;
    const int decimals = value >= 9.95 || value <= 0 ? 0 : value >= 0.095 ? 1 : 2;
    return QObject::tr("%1 mm").arg(QString::number(value, 'f', decimals));
}

QString captionOf(const ProbedPlace& place) {
    if (place.fitting) return QObject::tr("%1, being fitted").arg(snapText(place.snap));
    if (!place.under) return QObject::tr("no point here");
    if (!place.pick) return QObject::tr("no %1 here").arg(snapText(place.snap));
    if (!place.pick->feature)
        return QObject::tr("point, spacing %1").arg(millimetreText(place.under->localSpacing_m));
    const FittedFeature& feature = *place.pick->feature;
    const QString deviation = millimetreText(worstDeviation(feature));
    if (feature.mode == SnapMode::circle)
        return QObject::tr("circle, ⌀ %1 m, σ %2").arg(lengthText(2 * feature.radius), deviation);
    return QObject::tr("%1, σ %2").arg(snapText(feature.mode), deviation);
}

QString repeatNoiseText(const SceneState& scene, const Selection& selection,
                        const std::optional<PickHandle>& last) {
    std::vector<double> lengths, others;
    std::optional<double> lastLength;
    for (const PlacedRepeat& repeat : shownRepeats(scene, selection)) {
        if (repeat.ofPath) continue;
        const double length = (repeat.places[1] - repeat.places[0]).norm();
        lengths.push_back(length);
        if (last && last->object == selection.object() && last->key == repeat.key &&
            last->repeat == repeat.repeat)
            lastLength = length;
        else
            others.push_back(length);
    }
    const auto all = lengthStatistic(lengths, {}, {});
    if (!all) return {};
    if (lengths.size() == 1) return QObject::tr("1 repeat: %1 m").arg(lengthText(all->mean_m));
    QString text = QObject::tr("%1 repeats: mean %2 m, SD %3")
                       .arg(lengths.size())
                       .arg(lengthText(all->mean_m), millimetreText(all->repeatSd_m.value_or(0)));
    if (lastLength)
        text += QObject::tr("; the last one %1 from the mean of the others")
                    .arg(signedMillimetres(*lastLength - lengthStatistic(others, {}, {})->mean_m));
    return text;
}

QString figureNoiseText(const MeasuredScene& measured, const Selection& selection) {
    for (const MeasuredKind& kind : measured.kinds) {
        if (kind.object != selection.object() || kind.method != selection.method()) continue;
        if (kind.quantities.empty()) return {};
        const QuantityStatistic& main = kind.quantities.front();
        const QString text = QObject::tr("%1: %2").arg(said(main.label), toQt(quantitySentence(main)));
        if (!main.repeatSd) return QObject::tr("1 repeat, %1").arg(text);
        const bool metres = main.unit == QuantityUnit::metre;
        const QString sd =
            metres ? millimetreText(*main.repeatSd)
                   : QString::number(*main.repeatSd, 'g', 2) + ' ' + toQt(readableSymbol(main.unit));
        return QObject::tr("%1 repeats, %2, SD %3").arg(main.repeats.size()).arg(text, sd);
    }
    return {};
}

}  // namespace vestige
