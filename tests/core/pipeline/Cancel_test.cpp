#include <gtest/gtest.h>

#include "core/base/CancelScope.h"
#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/Reconstruct.h"
#include "core/pipeline/RegisterTogether.h"
#include "tests/core/pipeline/TinyCase.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

/// A job that is cancelled as soon as it says that this share of it is done.
struct Cancelled {
    explicit Cancelled(double share)
        : control(
              [this, share](double done, std::string_view) {
                  if (done >= share) control.cancel();
              },
              {}),
          scope(control) {}
    JobControl control;
    CancelScope scope;
};

class Cancelling : public testing::Test {
  public:
    void SetUp() override {
        for (Layer& layer : tiny.scene.layers) {
            auto data = loadLayerData(tiny.scene.resolve(layer.path), readOptionsOf(layer), {});
            ASSERT_TRUE(data) << data.error().sentence();
            layer.data = *data;
        }
    }
    test::TemporaryFolder folder;
    test::TinyCase tiny{folder.path()};
    test::NotingRenderer renderer;
    test::NotingPrinter printer;
};

TEST_F(Cancelling, EndsLoadingWhereverItIs) {
    for (const double share : {0.0, 0.2, 0.4, 0.6}) {
        const Cancelled job(share);
        const Layer& layer = tiny.scene.layers.front();
        const auto data = loadLayerData(tiny.scene.resolve(layer.path), readOptionsOf(layer), job.control);
        ASSERT_FALSE(data) << share;
        EXPECT_EQ(data.error().code, ErrorCode::cancelled) << share << ": " << data.error().sentence();
    }
}

TEST_F(Cancelling, EndsARegistration) {
    // One as small as this says next to nothing before its end.
    for (const double share : {0.0}) {
        const Cancelled job(share);
        const auto done =
            guarded("registering", [&] { return attemptLayers(tiny.scene, {"front"}, job.control); });
        // Of several layers each says how it ended.
        const Error* error = !done                                      ? &done.error()
                             : done->layers.empty()                     ? nullptr
                             : !done->layers.front().result.has_value() ? &done->layers.front().result.error()
                                                                        : nullptr;
        ASSERT_NE(error, nullptr) << share << ": it went on to the end";
        EXPECT_EQ(error->code, ErrorCode::cancelled) << share << ": " << error->sentence();
    }
}

TEST_F(Cancelling, EndsAReportWhereverItIsAndLeavesNothing) {
    for (Layer& layer : tiny.scene.layers) layer.data = nullptr;
    for (const double share : {0.0, 0.1, 0.2, 0.4, 0.6, 0.8}) {
        const Cancelled job(share);
        const auto done = guarded("the report", [&] {
            return reconstruct(tiny.scene, folder / "out", &renderer, &printer, job.control);
        });
        ASSERT_FALSE(done) << share;
        EXPECT_EQ(done.error().code, ErrorCode::cancelled) << share << ": " << done.error().sentence();
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / "manifest.json")) << share;
    }
}

}  // namespace
}  // namespace vestige
