#include "core/scene/MeasuredKinds.h"

#include <cmath>

#include "core/base/Numbers.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/CloudKinds.h"
#include "core/scene/KindOutcomes.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {
namespace {

void addNote(std::string& note, const std::string& sentence) {
    note += (note.empty() ? "" : "; ") + sentence;
}

std::string parametersText(const Measurement& measurement) {
    std::string text;
    const auto settings = kindSettings(measurement.kind, measurement.settings);
    if (!settings) return text;
    for (const ParameterSpec& spec : settings->table())
        if (!spec.key.starts_with("reference"))
            text += (text.empty() ? "" : " ") + spec.key + "=" + settings->display(spec.key);
    return text;
}

/// The tape for lengths; for other units what the case gives with the kind's own reference parameter.
void compare(const Measurement& measurement, std::vector<QuantityStatistic>& quantities) {
    constexpr double kTapeResolution_m = 0.01;
    if (quantities.empty()) return;
    QuantityStatistic& main = quantities.front();
    if (kindSpec(measurement.kind).isLength) {
        main.reference = measurement.tape_m;
        main.referenceUncertainty = tapeUncertainty(measurement.tapeResolution_m.value_or(kTapeResolution_m));
    } else {
        for (const auto& [key, value] : measurement.settings)
            if (key.starts_with("reference") && value > 0) main.reference = value;
    }
    if (!main.reference) main.referenceUncertainty.reset();
    if (main.reference) main.relativeError = relativeError(main.mean, *main.reference);
}

MeasuredKind measured(const SceneState& scene, const Measurement& measurement, const std::string& method,
                      const KindRepeats& repeats) {
    MeasuredKind result;
    result.object = measurement.object;
    result.method = method;
    result.kind = measurement.kind;
    result.parameters = parametersText(measurement);
    result.layers = repeats.layers;
    const CloudKindsLater* later = CloudKindsLater::current();
    const std::size_t left = later ? later->missing().size() : 0;
    KindOutcome outcome = outcomeOf(scene, repeats);
    const bool isLeft = later && later->missing().size() > left;
    for (const std::string& note : repeats.notes) addNote(result.note, note);
    for (const std::string& note : outcome.notes) addNote(result.note, note);
    result.quantities = std::move(outcome.quantities);
    result.series = std::move(outcome.series);
    if (isLeft) return result;
    if (result.quantities.empty()) {
        addNote(result.note, "not measured with this method");
    } else if (!result.quantities.front().expandedUncertainty) {
        addNote(result.note, "one repeat only, so no uncertainty");
    }
    compare(measurement, result.quantities);
    return result;
}

}  // namespace

const QuantityStatistic* MeasuredKind::find(const std::string& key) const {
    for (const QuantityStatistic& quantity : quantities)
        if (quantity.key == key) return &quantity;
    return nullptr;
}

std::vector<MeasuredKind> measureKinds(const SceneState& scene, const std::vector<std::string>& methods) {
    std::vector<MeasuredKind> all;
    for (const Measurement& measurement : scene.measurements)
        for (const std::string& method : methods) {
            const KindRepeats picked = kindRepeats(scene, measurement, method, false);
            all.push_back(measured(scene, measurement, method, picked));
            if (!hasFitted(scene, measurement, method)) continue;
            const KindRepeats fitted = kindRepeats(scene, measurement, method, true);
            if (!fitted.measurement.repeats.empty())
                all.push_back(measured(scene, measurement, method + " fitted", fitted));
        }
    return all;
}

std::optional<MeasuredLength> lengthOfKind(const std::vector<MeasuredKind>& kinds,
                                           const Measurement& measurement, const std::string& method) {
    if (!kindSpec(measurement.kind).isLength) return std::nullopt;
    for (const MeasuredKind& kind : kinds) {
        if (kind.object != measurement.object || kind.method != method) continue;
        constexpr double kTapeResolution_m = 0.01;
        MeasuredLength row;
        row.object = kind.object;
        row.method = kind.method;
        row.tape_m = measurement.tape_m;
        row.tapeUncertainty_m = tapeUncertainty(measurement.tapeResolution_m.value_or(kTapeResolution_m));
        row.layers = kind.layers;
        row.note = kind.note;
        if (kind.quantities.empty()) return row;
        const QuantityStatistic& main = kind.quantities.front();
        LengthStatistic length;
        length.repeats_m = main.repeats;
        length.mean_m = main.mean;
        length.repeatSd_m = main.repeatSd;
        length.standardUncertainty_m = main.standardUncertainty;
        length.degreesOfFreedom = main.degreesOfFreedom;
        length.expandedUncertainty_m = main.expandedUncertainty;
        if (main.expandedUncertainty) length.coverageFactor = main.budget.coverageFactor;
        row.length = std::move(length);
        row.re = main.relativeError;
        return row;
    }
    return std::nullopt;
}

}  // namespace vestige
