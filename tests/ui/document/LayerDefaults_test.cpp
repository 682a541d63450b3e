#include "ui/document/LayerDefaults.h"

#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

Layer layer(const std::string& name, double width, std::optional<double> metresPerUnit) {
    PointCloudBuilder builder;
    for (double x = 0; x <= width; x += width / 50)
        for (double y = 0; y <= width; y += width / 50) builder.add({x, y, 0});
    auto data = std::make_shared<LayerData>();
    data->geometry = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(builder).build(), {}});
    data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
    data->info.metresPerUnit = metresPerUnit;
    Layer made;
    made.id = made.name = name;
    made.data = std::move(data);
    return made;
}

TEST(RecogniseUnits, BelievesTheFileBeforeTheSize) {
    std::vector<Layer> layers{layer("site", 328, 1200.0 / 3937.0), layer("inches", 50, 0.0254),
                              layer("metres", 2000, 1), layer("unsaid", 4000, std::nullopt)};
    const std::vector<std::string> remarks = recogniseUnits(layers, {});
    EXPECT_EQ(layers[0].unit, LengthUnit::usSurveyFoot);
    EXPECT_EQ(layers[1].unit, LengthUnit::inch);
    EXPECT_EQ(layers[2].unit, LengthUnit::metre) << "however large it is";
    EXPECT_EQ(layers[3].unit, LengthUnit::millimetre);
    ASSERT_EQ(remarks.size(), 3);
    EXPECT_EQ(remarks[0], "site is in US survey feet, as its file says");
    EXPECT_EQ(remarks[1], "inches is in inches, as its file says");
    EXPECT_NE(remarks[2].find("unsaid is taken to be in millimetres"), std::string::npos);
}

TEST(RecogniseUnits, AFileWithAUnitOfItsOwnGoesOnSayingIt) {
    std::vector<Layer> layers{layer("site", 10, 1), layer("old", 4000, 0.3047972654)};
    const std::vector<std::string> remarks = recogniseUnits(layers, {});
    EXPECT_FALSE(layers[1].unit);
    EXPECT_EQ(layers[1].metresPerUnit(), 0.3047972654);
    ASSERT_EQ(remarks.size(), 1);
    EXPECT_EQ(remarks[0], "old is in units of 0.3047972654 m, as its file says");
}

TEST(RecogniseUnits, ComparesWithTheTargetInMetres) {
    std::vector<Layer> layers{layer("site", 50000, 0.001), layer("scan", 2000, std::nullopt)};
    recogniseUnits(layers, {});
    EXPECT_EQ(layers[1].unit, LengthUnit::millimetre) << "50 m are far less than 2000 m";
}

TEST(Layer, TakesItsUnitFromTheFileWhereNoneIsGiven) {
    Layer feet = layer("a", 10, 0.3048);
    EXPECT_EQ(feet.metresPerUnit(), 0.3048);
    EXPECT_EQ(feet.lengthUnit(), LengthUnit::foot);
    EXPECT_EQ(sceneFromLayer(feet).scale, 0.3048);
    feet.unit = LengthUnit::millimetre;
    EXPECT_EQ(feet.metresPerUnit(), 0.001);
    EXPECT_EQ(layer("b", 10, std::nullopt).metresPerUnit(), 1);
    EXPECT_EQ(layer("c", 10, 0.3047972654).metresPerUnit(), 0.3047972654) << "a foot that is not ours";
    EXPECT_FALSE(layer("c", 10, 0.3047972654).fileUnit());
}

}  // namespace
}  // namespace vestige
