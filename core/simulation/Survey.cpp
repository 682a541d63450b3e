#include "core/simulation/Survey.h"

namespace vestige {
namespace {

CircularFlight flightOf(const SceneSpec& spec) {
    CircularFlight flight;
    flight.target = {spec.flight.real("target_x_m"), spec.flight.real("target_y_m"), 0};
    flight.radius_m = spec.flight.real("radius_m");
    flight.height_m = spec.flight.real("height_m");
    flight.secondsPerCircle = spec.flight.real("circle_s");
    return flight;
}

std::vector<Probe> featureProbes(const SurfaceModel& surfaces) {
    std::vector<Probe> probes;
    for (const FeaturePoint& feature : surfaces.features) probes.push_back({feature.position, feature.part});
    return probes;
}

std::vector<bool> shown(const std::vector<std::uint32_t>& counts, std::size_t features,
                        const ShownRule& rule) {
    std::vector<bool> all(features);
    for (std::size_t i = 0; i < features; ++i) all[i] = counts[i] >= rule.echoes;
    return all;
}

Status scanAllByHand(const SceneSpec& spec, const RayTracer& tracer, std::uint64_t seed, Survey& survey,
                     const JobControl& control) {
    const ProbeCounter probes(featureProbes(survey.scene.surfaces), kShownByHandheld.radius_m);
    for (std::size_t i = 0; i < spec.handheld.size(); ++i) {
        const HandheldSpec& layer = spec.handheld[i];
        control.progress(static_cast<double>(i) / static_cast<double>(spec.handheld.size()), "handheld scan");
        Result<HandheldScan> scan =
            scanByHand(tracer, survey.scene.surfaces, einScanPro2X(), layer,
                       survey.scene.siteFromObject.at(layer.object), seed, probes, control);
        if (!scan) return fail(scan.error());
        survey.handheld.push_back({layer.id, std::move(*scan), {}});
    }
    return {};
}

/// The aerial scan, and with what it counted at sampled handheld places the rough pairs.
Status scanFromAirAndPair(const SceneSpec& spec, const RayTracer& tracer, std::uint64_t seed, double seconds,
                          Survey& survey, const JobControl& control) {
    std::vector<Probe> probes = featureProbes(survey.scene.surfaces);
    for (const HandheldLayer& layer : survey.handheld)
        probes.insert(probes.end(), layer.scan.sample.begin(), layer.scan.sample.end());
    AerialOptions options;
    options.flight = flightOf(spec);
    options.seconds = seconds;
    options.repetitive = spec.flight.text("pattern") == "repetitive";
    options.seed = seed;
    options.worldFromSite = survey.worldFromSite;
    options.gpsTime_s = spec.site.gpsTime_s;
    Result<AerialScan> scan = scanFromAir(tracer, survey.scene.surfaces, zenmuseL1(), options,
                                          ProbeCounter(probes, kShownByAerial.radius_m), control);
    if (!scan) return fail(scan.error());
    survey.aerial = std::move(*scan);
    auto counts = survey.aerial.probeCounts.begin() +
                  static_cast<std::ptrdiff_t>(survey.scene.surfaces.features.size());
    for (HandheldLayer& layer : survey.handheld) {
        const auto end = counts + static_cast<std::ptrdiff_t>(layer.scan.sample.size());
        Result<std::vector<RoughPair>> pairs =
            roughPairs(layer.scan, {counts, end}, survey.worldFromSite, layer.id, seed);
        if (!pairs) return fail(pairs.error());
        layer.pairs = std::move(*pairs);
        counts = end;
    }
    return {};
}

}  // namespace

std::vector<ShownLayer> Survey::shownLayers(bool withHandheld) const {
    const std::size_t features = scene.surfaces.features.size();
    Similarity world;
    world.pose.translation() = worldFromSite;
    std::vector<ShownLayer> layers;
    layers.push_back({"aerial", "lidar", false, false, world, 0.002, 2.0,
                      shown(aerial.probeCounts, features, kShownByAerial)});
    if (withHandheld)
        for (const HandheldLayer& layer : handheld)
            layers.push_back({layer.id, "lidar", true, true, layer.scan.siteFromLayer.inverse(), 0.00025, 0.6,
                              shown(layer.scan.probeCounts, features, kShownByHandheld)});
    if (photo)
        layers.push_back({"photo", "photogrammetry", false, true, photo->siteFromLayer.inverse(), 0.004, 2.0,
                          shown(photo->probeCounts, features, kShownByPhotographs)});
    return layers;
}

Result<Survey> surveyScene(const SceneSpec& spec, std::uint64_t seed, double seconds,
                           const JobControl& control) {
    Result<SceneModel> scene = buildScene(spec, seed);
    if (!scene) return fail(scene.error());
    Survey survey;
    survey.scene = std::move(*scene);
    survey.worldFromSite = {spec.site.easting_m, spec.site.northing_m, spec.site.height_m};
    const RayTracer tracer(survey.scene.surfaces);
    if (const Status done = scanAllByHand(spec, tracer, seed, survey, control.sub(0, 0.1)); !done)
        return fail(done.error());
    if (const Status done = scanFromAirAndPair(spec, tracer, seed, seconds, survey, control.sub(0.1, 0.85));
        !done)
        return fail(done.error());
    if (spec.photogrammetry.boolean("enabled")) {
        control.progress(0.85, "photogrammetry");
        Result<PhotogrammetryScan> photo = photographScene(
            tracer, survey.scene.surfaces, flightOf(spec), spec.photogrammetry, survey.worldFromSite, seed,
            ProbeCounter(featureProbes(survey.scene.surfaces), kShownByPhotographs.radius_m), control);
        if (!photo) return fail(photo.error());
        survey.photo = std::move(*photo);
    }
    return survey;
}

}  // namespace vestige
