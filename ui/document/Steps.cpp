#include "ui/document/Steps.h"

#include <QObject>
#include <algorithm>

#include "core/measurement/kinds/KindSpec.h"
#include "core/pipeline/RegisterLayers.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

/// Repeats that make a measurement.
constexpr std::size_t kRepeats = 3;

/// "Name SENTENCE" for one, "N OTHERS" for more.
QString oneOrMany(const QStringList& names, const QString& one, const QString& many) {
    return names.size() == 1 ? one.arg(names.front()) : many.arg(names.size());
}

QString nameOf(const Layer& layer) {
    return toQt(layer.name.empty() ? layer.id : layer.name);
}

StepFacts importFacts(const SceneState& scene) {
    StepFacts facts;
    facts.step = WayStep::import;
    if (scene.layers.empty()) {
        facts.state = StepState::open;
        facts.missing << QObject::tr("no scans yet");
        facts.summary = QObject::tr("Add the scans of the scene; the first is the frame of all others.");
        return facts;
    }
    QStringList unread, reading;
    std::uint64_t points = 0;
    for (const Layer& layer : scene.layers) {
        if (!layer.data)
            unread << nameOf(layer);
        else if (layer.data->isPreview())
            reading << nameOf(layer);
        if (layer.data) points += layer.data->points->size();
    }
    if (!unread.isEmpty())
        facts.missing << oneOrMany(unread, QObject::tr("%1 was not read"),
                                   QObject::tr("%1 files were not read"));
    if (!reading.isEmpty())
        facts.missing << oneOrMany(reading, QObject::tr("%1 is still being read"),
                                   QObject::tr("%1 files are still being read"));
    facts.state = facts.missing.isEmpty() ? StepState::done : StepState::open;
    facts.summary = scene.layers.size() == 1
                        ? QObject::tr("1 scan, %1 points").arg(countText(points))
                        : QObject::tr("%1 scans, %2 points").arg(scene.layers.size()).arg(countText(points));
    return facts;
}

StepFacts alignFacts(const SceneState& scene) {
    StepFacts facts;
    facts.step = WayStep::align;
    const bool any = std::any_of(scene.layers.begin(), scene.layers.end(),
                                 [](const Layer& layer) { return layer.data != nullptr; });
    if (!any) {
        facts.summary = QObject::tr("Comes after the scans are read.");
        return facts;
    }
    QStringList open, doubtful;
    std::size_t registered = 0;
    for (const Layer& layer : scene.layers) {
        registered += layer.registration.has_value();
        if (layer.registration && layer.registration->verdict == Verdict::doubtful)
            doubtful << nameOf(layer);
        else if (!layer.registration && needsRegistration(scene, layer))
            open << nameOf(layer);
    }
    if (scene.layers.size() > 1 && !scene.layer(scene.target))
        facts.missing << QObject::tr("no layer is the target");
    if (!open.isEmpty())
        facts.missing << oneOrMany(open, QObject::tr("%1 is not registered"),
                                   QObject::tr("%1 scans are not registered"));
    if (!doubtful.isEmpty())
        facts.missing << oneOrMany(doubtful, QObject::tr("the fit of %1 is doubtful"),
                                   QObject::tr("%1 fits are doubtful"));
    facts.state = facts.missing.isEmpty() ? StepState::done : StepState::open;
    facts.summary = scene.layers.size() == 1 ? QObject::tr("One scan: there is nothing to align.")
                    : registered == 0        ? QObject::tr("No scan needs to be registered.")
                    : registered == 1        ? QObject::tr("1 scan is registered.")
                                             : QObject::tr("%1 scans are registered.").arg(registered);
    return facts;
}

StepFacts cleanFacts(const SceneState& scene) {
    StepFacts facts;
    facts.step = WayStep::clean;
    if (scene.layers.empty()) {
        facts.summary = QObject::tr("Comes after the scans are read.");
        return facts;
    }
    const auto cleaned = std::count_if(scene.layers.begin(), scene.layers.end(),
                                       [](const Layer& layer) { return layer.cleaning != nullptr; });
    facts.state = cleaned > 0 || !scene.objects.empty() ? StepState::done : StepState::optional;
    facts.summary =
        facts.state == StepState::optional
            ? QObject::tr("Optional: take away what disturbs, separate objects.")
            : QObject::tr("%1 layers cleaned, %2 objects separated.").arg(cleaned).arg(scene.objects.size());
    return facts;
}

std::size_t repeatsOf(const Measurement& measurement) {
    std::size_t most = 0;
    for (const auto& [key, pairs] : measurement.picks) most = std::max(most, pairs.size());
    for (const auto& [key, paths] : measurement.paths) most = std::max(most, paths.size());
    return most;
}

StepFacts measureFacts(const SceneState& scene) {
    StepFacts facts;
    facts.step = WayStep::measure;
    if (scene.layers.empty()) {
        facts.summary = QObject::tr("Comes after the scans are read.");
        return facts;
    }
    QStringList untouched, few, aims;
    for (const Measurement& measurement : scene.measurements) {
        const std::size_t repeats = repeatsOf(measurement);
        const QString name = toQt(measurement.object);
        if (repeats == 0 && !measurement.aims.empty())
            aims << name;
        else if (repeats == 0)
            untouched << name;
        else if (repeats < kRepeats)
            few << name;
    }
    if (scene.measurements.empty()) facts.missing << QObject::tr("nothing is measured yet");
    if (!aims.isEmpty())
        facts.missing << oneOrMany(aims, QObject::tr("%1 has recorded aims to take"),
                                   QObject::tr("%1 objects have recorded aims to take"));
    if (!untouched.isEmpty())
        facts.missing << oneOrMany(untouched, QObject::tr("%1 is not measured"),
                                   QObject::tr("%1 objects are not measured"));
    if (!few.isEmpty())
        facts.missing << oneOrMany(few, QObject::tr("%1 has fewer than 3 repeats"),
                                   QObject::tr("%1 objects have fewer than 3 repeats"));
    facts.state = facts.missing.isEmpty() ? StepState::done : StepState::open;
    facts.summary = scene.measurements.size() == 1 ? QObject::tr("1 object")
                                                   : QObject::tr("%1 objects").arg(scene.measurements.size());
    return facts;
}

StepFacts reportFacts(const SceneState& scene, const MeasuredScene& measured, bool reported) {
    StepFacts facts;
    facts.step = WayStep::report;
    const bool any = std::any_of(measured.lengths.begin(), measured.lengths.end(),
                                 [](const MeasuredLength& length) { return length.length.has_value(); });
    const bool paths = std::any_of(scene.measurements.begin(), scene.measurements.end(),
                                   [](const Measurement& m) { return !m.paths.empty(); });
    if (!any && !paths) {
        facts.summary = QObject::tr("Comes after something is measured.");
        return facts;
    }
    QStringList tapeless;
    for (const Measurement& measurement : scene.measurements)
        if (!measurement.tape_m && kindSpec(measurement.kind).isLength) tapeless << toQt(measurement.object);
    if (!tapeless.isEmpty())
        facts.missing << oneOrMany(tapeless, QObject::tr("%1 has no tape value"),
                                   QObject::tr("%1 objects without a tape value"));
    if (scene.operatorName.empty()) facts.missing << QObject::tr("no operator is named");
    if (!reported) facts.missing << QObject::tr("not written yet");
    facts.state = reported ? StepState::done : StepState::open;
    facts.summary = reported ? QObject::tr("Written, and nothing has changed since.")
                             : QObject::tr("Not written of the case as it is.");
    return facts;
}

}  // namespace

QString titleOf(WayStep step) {
    switch (step) {
        case WayStep::import:
            return QObject::tr("Import");
        case WayStep::align:
            return QObject::tr("Align");
        case WayStep::clean:
            return QObject::tr("Clean");
        case WayStep::measure:
            return QObject::tr("Measure");
        case WayStep::report:
            break;
    }
    return QObject::tr("Report");
}

std::array<StepFacts, kWaySteps> stepsOf(const SceneState& scene, const MeasuredScene& measured,
                                         bool reported) {
    return {importFacts(scene), alignFacts(scene), cleanFacts(scene), measureFacts(scene),
            reportFacts(scene, measured, reported)};
}

WayStep nextStep(const std::array<StepFacts, kWaySteps>& steps) {
    for (const StepFacts& facts : steps)
        if (facts.state == StepState::open) return facts.step;
    return WayStep::report;
}

}  // namespace vestige
