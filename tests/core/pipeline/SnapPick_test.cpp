#include "core/pipeline/SnapPick.h"

#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

Layer plateOf(LayerRole role) {
    PointCloudBuilder builder;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) builder.add(Eigen::Vector3d(0.02 * x, 0.02 * y, 0));
    auto data = std::make_shared<LayerData>();
    data->points = std::make_shared<const PointCloud>(std::move(builder).build());
    data->octree = std::make_shared<const Octree>(data->points);
    Layer layer;
    layer.id = layer.name = "plate";
    layer.role = role;
    layer.data = data;
    return layer;
}

TEST(SnapPick, FitsNothingWherePointsErrTogether) {
    const Eigen::Vector3d middle(0.6, 0.6, 0);
    const Eigen::Vector3d down(0, 0, -1);
    for (const LayerRole role : {LayerRole::aerial, LayerRole::handheld})
        EXPECT_TRUE(snapPick(plateOf(role), middle, down, SnapMode::plane, nullptr));
    const auto refused = snapPick(plateOf(LayerRole::photogrammetry), middle, down, SnapMode::plane, nullptr);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("err together"), std::string::npos);
}

}  // namespace
}  // namespace vestige
