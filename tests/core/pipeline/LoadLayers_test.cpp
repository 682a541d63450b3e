#include "core/pipeline/LoadLayers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "core/base/AtomicFile.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/LasWriter.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// Four points with intensity and what only exports ask for.
void writePoints(const fs::path& file, double height) {
    PointCloudBuilder builder(Eigen::Vector3d::Zero());
    builder.resize(4);
    for (std::uint32_t i = 0; i < 4; ++i) builder.setPoint(i, {1.0 * i, 1.0 * (i % 2), height});
    builder.attributes().intensity.resize(4);
    builder.attributes().classification = {2, 2, 6, 6};
    const PointCloud cloud = std::move(builder).build();
    ASSERT_TRUE(writeLas(file, {{&cloud, {}, 1}}, {}));
}

/// A glTF scene of three points whose coordinates are in `points.bin`.
fs::path writeScene(const fs::path& folder) {
    const std::vector<float> places{0, 0, 0, 1, 0, 0, 0, 1, 0};
    EXPECT_TRUE(
        writeTextFile(folder / "points.bin", std::string(reinterpret_cast<const char*>(places.data()), 36)));
    EXPECT_TRUE(writeTextFile(folder / "scene.gltf", R"({"asset":{"version":"2.0"},"scene":0,
        "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":"points.bin","byteLength":36}]})"));
    return folder / "scene.gltf";
}

/// Does something once, when a step of that name begins.
JobControl when(const std::string& step, std::function<void()> action) {
    return JobControl(
        [step, action = std::move(action), done = std::make_shared<std::atomic<bool>>(false)](
            double, std::string_view text) {
            if (text.starts_with(step) && !done->exchange(true)) action();
        },
        [](std::string_view) {});
}

TEST(LoadLayers, ACompanionThatChangesAfterItWasReadAndBeforeItIsHashedIsTold) {
    const test::TemporaryFolder folder;
    const fs::path scene = writeScene(folder.path());
    const auto whole = loadLayerData(scene, {}, {});
    ASSERT_TRUE(whole) << whole.error().sentence();
    ASSERT_EQ((*whole)->info.companions.size(), 1U);
    const auto loaded = loadLayerData(
        scene, {},
        when("index of", [&] { ASSERT_TRUE(writeTextFile(folder / "points.bin", std::string(36, '\0'))); }));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().sentence().find("points.bin"), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().sentence().find("changed while it was being read"), std::string::npos);
}

TEST(LoadLayers, AttributesOfAFileThatHasChangedAreNotMixedWithPointsReadBefore) {
    const test::TemporaryFolder folder;
    writePoints(folder / "a.las", 1);
    Layer layer;
    layer.path = folder / "a.las";
    const auto data = loadLayerData(layer.path, readOptionsOf(layer), {});
    ASSERT_TRUE(data) << data.error().sentence();
    layer.data = *data;
    const auto all = allAttributes(layer, layer.path, {});
    ASSERT_TRUE(all) << all.error().sentence();
    EXPECT_EQ((*all)->attributes().classification.size(), 4U);
    writePoints(folder / "a.las", 2);
    const auto others = allAttributes(layer, layer.path, {});
    ASSERT_FALSE(others) << "as many points, at other places";
    EXPECT_NE(others.error().sentence().find("has changed"), std::string::npos) << others.error().sentence();
}

TEST(LoadLayers, CancellingDoesNotWaitForTheHash) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "long.las";
    writePoints(file, 1);
    fs::resize_file(file, std::uintmax_t{200} << 30);  // but for its beginning a hole
    JobControl control;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        control.cancel();
    });
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = loadLayerData(file, {}, control);
    const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    canceller.join();
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::cancelled) << loaded.error().sentence();
    EXPECT_LT(seconds, 20);
}

}  // namespace
}  // namespace vestige
