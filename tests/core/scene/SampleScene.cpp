#include "tests/core/scene/SampleScene.h"

#include <gtest/gtest.h>

#include "core/scene/CaseFile.h"

namespace vestige::test {

Layer sampleLayer(const std::string& id, LayerRole role) {
    Layer layer;
    layer.id = id;
    layer.name = "Layer " + id;
    layer.role = role;
    layer.method = std::string(defaultMethod(role));
    layer.path = "/data/" + id + ".ply";
    layer.unit = role == LayerRole::handheld ? LengthUnit::millimetre : LengthUnit::metre;
    layer.tint = {1, 2, 3};
    static const auto data = std::make_shared<const LayerData>();
    layer.data = data;
    return layer;
}

RegistrationQuality sampleQuality() {
    RegistrationQuality quality;
    quality.residuals = {0.002, {1, 5, 9, 4, 0}, 3};
    quality.planeRmse_m = 0.0041;
    quality.restarts = {4, 3, 0.0011, 0.0002};
    for (int i = 0; i < 6; ++i)
        quality.directions.push_back(
            {10.0 / 3 * i, Vector6d::Unit(i), 1.0 / (i + 1), i == 0, "slides level about east-west"});
    quality.radius_m = 12.3;
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            quality.uncertainty.covariance(row, column) = (row == column ? 2 : 0.1) * 1e-6 / 3;
    quality.uncertainty.pivot_m = {1.5, -2, 1.0 / 7};
    return quality;
}

RegistrationResult sampleResult(double shift_m, double angle_rad) {
    RegistrationResult result;
    result.method = "improved-ndt";
    result.targetFromSource.pose.linear() =
        Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    result.targetFromSource.pose.translation() = Eigen::Vector3d(shift_m, 2 * shift_m, -shift_m);
    result.targetFromSource.scale = 0.001;
    result.initial = result.targetFromSource;
    result.converged = true;
    result.iterations = 41;
    result.seconds = 1.0 / 3;
    result.rmse_m = 0.0123;
    result.overlap = 0.7;
    result.targetOverlap = 0.6;
    result.inlierDistance_m = 0.15;
    result.reasons = {"too little overlap"};
    result.voxelSchedule_m = {1, 0.8, 0.64};
    result.levels = {{1, 20, -0.4, StopReason::step, result.targetFromSource.pose},
                     {0.8, 21, -0.5, StopReason::iterationLimit, result.targetFromSource.pose}};
    result.notes = {"the scan is in millimetres"};
    result.verdict = Verdict::doubtful;
    result.candidates = {{result.targetFromSource, 0.75}};
    result.quality = sampleQuality();
    return result;
}

SceneState sampleScene() {
    SceneState scene;
    scene.name = "Crossing";
    scene.operatorName = "M\xc3\xbcller, \"K\"";
    scene.site = Site{52.1, -0.3, 34.5};
    scene.layers = {sampleLayer("aerial", LayerRole::aerial), sampleLayer("front", LayerRole::handheld),
                    sampleLayer("photo", LayerRole::photogrammetry)};
    scene.layers[1].init = InitPicks{"/data/front_picks.csv"};
    scene.layers[1].registration = sampleResult(0.1, 0.2);
    scene.layers[2].visible = false;
    scene.target = "aerial";
    EXPECT_TRUE(scene.preprocess.set("voxel_m", 0.2));
    EXPECT_TRUE(scene.registration.setFromText("preset", "paper"));
    const auto at = [](const std::string& layer, double x, double y, double z) {
        return PickedPoint{layer, {x, y, z}, {}, false};
    };
    Measurement length;
    length.object = "Length of the vehicle";
    length.tape_m = 4.93;
    length.tapeResolution_m = 0.005;
    length.picks["aerial"] = {{at("aerial", 0, 0, 1.0 / 3), at("aerial", 4.9, 0, 0)},
                              {at("aerial", 0, 0.01, 0), {"aerial", {4.95, 0, 0}, 0.02, false}}};
    length.picks["front"] = {{at("front", 1, 2, 3), at("aerial", 4.9, 0, 0)}};
    length.picks["photo"] = {};
    Measurement mirror;
    mirror.object = "Right rearview mirror";
    mirror.picks["photo"] = {{{"photo", {1, 1, 1}, 0.05, true}, {"photo", {1.2, 1, 1}, 0.05, true}}};
    mirror.aims["lidar"] = {
        {{"side", {700.5, 450.25}, {"front", "aerial"}}, {"side", {710, 450}, {"front"}}}};
    scene.measurements = {length, mirror};
    ViewCamera side;
    side.position = {10, 0, 2.5};
    side.viewUp = {0, 0, 1};
    side.parallel = true;
    side.halfHeight_m = 0.7;
    scene.views["side"] = side;
    scene.viewFrames["side"] = "front";
    scene.views["top"] = ViewCamera{};
    scene.file = "/cases/crossing.vestige";
    return scene;
}

bool equal(const SceneState& a, const SceneState& b) {
    if (caseText(a) != caseText(b) || a.file != b.file || a.viewFrames != b.viewFrames) return false;
    for (std::size_t i = 0; i < a.layers.size(); ++i)
        if (a.layers[i].data != b.layers[i].data) return false;
    return a.measurements == b.measurements;
}

}  // namespace vestige::test
