#include "core/pipeline/InitialPlacement.h"

#include <gtest/gtest.h>

#include "core/geometry/PointCloudBuilder.h"
#include "core/scene/LayerUnit.h"

namespace vestige {
namespace {

constexpr double kClarkesFoot = 0.3047972654;

/// A level square of that many units.
Layer layer(const std::string& id, double width, std::optional<LengthUnit> unit,
            std::optional<double> ofFile = std::nullopt) {
    PointCloudBuilder builder;
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 100; ++k) builder.add({i * width / 99, k * width / 99, 0});
    auto data = std::make_shared<LayerData>();
    data->geometry = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(builder).build(), {}});
    data->points = {data->geometry, &data->geometry->vertices};
    data->info.metresPerUnit = ofFile;
    Layer made;
    made.id = id;
    made.unit = unit;
    made.data = std::move(data);
    made.init = InitIdentity{};
    return made;
}

InitialPlacement placed(const Layer& source, const Layer& target) {
    const auto placement = initialPlacement({}, source, target);
    if (!placement) throw ErrorException{placement.error()};
    return *placement;
}

TEST(InitialPlacement, ComparesTheSourceWithTheTargetInMetres) {
    const Layer site = layer("site", 50000, LengthUnit::millimetre);
    const InitialPlacement guessed = placed(layer("front", 2000, std::nullopt), site);
    EXPECT_EQ(guessed.targetFromSource.scale, 0.001);
    ASSERT_EQ(guessed.notes.size(), 1);
    EXPECT_NE(guessed.notes[0].find("the target 70.71 m"), std::string::npos) << guessed.notes[0];
    EXPECT_TRUE(placed(layer("front", 2000, LengthUnit::millimetre), site).notes.empty())
        << "nothing speaks against the case's word";
    // A target whose file says the unit, and a scan that is as wide in metres.
    const Layer feet = layer("site", 328, std::nullopt, 0.3048);
    EXPECT_EQ(placed(layer("flight", 100, std::nullopt), feet).targetFromSource.scale, 1);
}

TEST(InitialPlacement, TakesAFileAtItsWordWhateverItsUnit) {
    const Layer site = layer("site", 100, LengthUnit::metre);
    const InitialPlacement clarke = placed(layer("old", 328, std::nullopt, kClarkesFoot), site);
    EXPECT_EQ(clarke.targetFromSource.scale, kClarkesFoot);
    ASSERT_EQ(clarke.notes.size(), 1);
    EXPECT_NE(clarke.notes[0].find("units of 0.3047972654 m"), std::string::npos) << clarke.notes[0];
    const InitialPlacement given = placed(layer("old", 328, LengthUnit::foot, kClarkesFoot), site);
    EXPECT_EQ(given.targetFromSource.scale, 0.3048) << "the case's word counts more";
    EXPECT_EQ(given.notes.size(), 1) << "and the difference is told";
    // A US survey foot that was written with fewer digits is the exact one.
    EXPECT_EQ(placed(layer("us", 328, std::nullopt, 0.3048006096), site).targetFromSource.scale,
              1200.0 / 3937);
}

TEST(LayerUnit, IsTheSameBeforeAndAfterARegistration) {
    Layer clarke = layer("old", 10, std::nullopt, kClarkesFoot);
    noteUnit(clarke, kClarkesFoot);
    EXPECT_EQ(clarke.metresPerUnit(), kClarkesFoot);
    EXPECT_FALSE(clarke.unit);
    noteUnit(clarke, 0.001);
    EXPECT_EQ(clarke.unit, LengthUnit::millimetre) << "pairs may say that the file is wrong";
    Layer feet = layer("feet", 10, std::nullopt, 0.3048);
    noteUnit(feet, 0.3048);
    EXPECT_EQ(feet.unit, LengthUnit::foot);
    Layer unsaid = layer("unsaid", 10, std::nullopt);
    noteUnit(unsaid, 1);
    EXPECT_EQ(unsaid.unit, LengthUnit::metre);
    noteUnit(unsaid, 0.001);
    EXPECT_EQ(unsaid.unit, LengthUnit::metre) << "it has one";
}

}  // namespace
}  // namespace vestige
