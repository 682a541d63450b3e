#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/simulation/SurveyFiles.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Json similarityJson(const Similarity& targetFromLayer) {
    return {{"pose", rowMajor(targetFromLayer.pose)}, {"scale", targetFromLayer.scale}};
}

/// Target frame from the layer's file: the site's place in the world after the layer's place in the site.
Similarity targetFrom(const Survey& survey, const Similarity& siteFromLayer) {
    Similarity target = siteFromLayer;
    target.pose.pretranslate(survey.worldFromSite);
    return target;
}

Json layersJson(const Survey& survey) {
    Json layers{{"aerial", similarityJson({})}};
    for (const HandheldLayer& layer : survey.handheld)
        layers[layer.id] = similarityJson(targetFrom(survey, layer.scan.siteFromLayer));
    if (survey.photo) layers["photo"] = similarityJson(targetFrom(survey, survey.photo->siteFromLayer));
    return layers;
}

/// The features of the measurements: true place, and which layers show them.
Json featuresJson(const Survey& survey, const SceneSpec& spec) {
    const std::vector<ShownLayer> layers = survey.shownLayers(true);
    const SurfaceModel& surfaces = survey.scene.surfaces;
    Json features = Json::object();
    for (const MeasurementSpec& measurement : spec.measurements) {
        for (const std::string& name : {measurement.from, measurement.to}) {
            const FeaturePoint* feature = surfaces.feature(name);
            const auto index = static_cast<std::size_t>(feature - surfaces.features.data());
            Json shownBy = Json::array();
            for (const ShownLayer& layer : layers)
                if (layer.shows[index]) shownBy.push_back(layer.id);
            features[name] = {{"position", triple(survey.worldFromSite + feature->position)},
                              {"part", surfaces.parts[feature->part]},
                              {"shown_by", shownBy}};
        }
    }
    return features;
}

Json measurementsJson(const Survey& survey, const SceneSpec& spec) {
    Json measurements = Json::array();
    for (const MeasurementSpec& measurement : spec.measurements) {
        const Eigen::Vector3d from = survey.scene.surfaces.feature(measurement.from)->position;
        const Eigen::Vector3d to = survey.scene.surfaces.feature(measurement.to)->position;
        measurements.push_back({{"object", measurement.object},
                                {"tape_m", measurement.tape_m},
                                {"true_m", (to - from).norm()},
                                {"from", measurement.from},
                                {"to", measurement.to}});
    }
    return measurements;
}

Json objectsJson(const Survey& survey, const SceneSpec& spec) {
    Json objects = Json::object();
    for (const ObjectSpec& object : spec.objects) {
        if (object.kind->name == "ground") continue;
        Pose pose = survey.scene.siteFromObject.at(object.id);
        pose.pretranslate(survey.worldFromSite);
        objects[object.id] = {{"kind", object.kind->name}, {"pose", rowMajor(pose)}};
    }
    return objects;
}

}  // namespace

Status writeTruth(const Survey& survey, const SceneSpec& spec, const SimulationOptions& options,
                  const AimOptions& aims, const std::filesystem::path& file) {
    Json scales = Json::object();
    for (const ShownLayer& layer : survey.shownLayers(true))
        scales[layer.id] = {{"metres_per_pixel", layer.metresPerPixel},
                            {"view_distance_m", layer.viewDistance_m}};
    const Json json{{"scene", spec.name},
                    {"seed", options.seed},
                    {"seconds", options.seconds},
                    {"world_from_site", triple(survey.worldFromSite)},
                    {"pulses", survey.aerial.pulses},
                    {"layers", layersJson(survey)},
                    {"measurements", measurementsJson(survey, spec)},
                    {"features", featuresJson(survey, spec)},
                    {"objects", objectsJson(survey, spec)},
                    {"aiming", {{"sigma_px", aims.sigma_px}, {"repeats", aims.repeats}, {"views", scales}}}};
    return writeTextFile(file, json.dump(1) + "\n");
}

}  // namespace vestige
