#include "core/filters/Preprocess.h"

#include <gtest/gtest.h>

#include "core/filters/Neighbourhood.h"
#include "core/filters/Outliers.h"
#include "core/filters/VoxelDownsample.h"
#include "tests/core/filters/FilterClouds.h"

using namespace vestige;
using namespace vestige::test;

TEST(Preprocess, DefaultsAreTheMethods) {
    const ParameterSet parameters(preprocessParameters());
    EXPECT_EQ(parameters.text("filter"), "gaussian");
    EXPECT_FALSE(parameters.optionalReal("radius_m"));
    EXPECT_FALSE(parameters.optionalReal("voxel_m"));
    EXPECT_EQ(parameters.text("representative"), "centroid");
    EXPECT_EQ(parameters.text("outliers"), "none");
    for (const char* flag : {"filter", "radius", "voxel", "representative", "outliers"})
        EXPECT_TRUE(std::any_of(preprocessParameters().begin(), preprocessParameters().end(),
                                [&](const ParameterSpec& spec) { return spec.flag == flag; }))
            << flag;
}

TEST(Preprocess, IsItsStepsInTheirOrder) {
    const PointCloud cloud = cloudOf(roughScene(20000, {5, 5, 5}));
    ParameterSet parameters(preprocessParameters());
    ASSERT_TRUE(parameters.set("filter", std::string("median")));
    ASSERT_TRUE(parameters.set("radius_m", 0.12));
    ASSERT_TRUE(parameters.set("voxel_m", 0.2));
    ASSERT_TRUE(parameters.set("representative", std::string("nearest")));
    ASSERT_TRUE(parameters.set("outliers", std::string("ror")));
    ASSERT_TRUE(parameters.set("ror_neighbours", std::int64_t{3}));
    const auto result = preprocess(cloud, parameters);
    ASSERT_TRUE(result);

    OutlierOptions outliers;
    outliers.method = OutlierMethod::radius;
    outliers.radius = 0.12;
    outliers.minimumNeighbours = 3;
    const auto kept = removeOutliers(cloud, outliers);
    EXPECT_LT(kept->size(), cloud.size());
    const auto filtered = filterNeighbourhood(*kept, {NeighbourhoodFilter::median, 0.12});
    expectIdentical(*result, *downsample(*filtered, 0.2, VoxelRepresentative::nearest));
}

TEST(Preprocess, LengthsAreMetresWhateverTheUnit) {
    const auto metres = roughScene(10000, {0, 0, 0});
    std::vector<Eigen::Vector3d> millimetres;
    for (const Eigen::Vector3d& point : metres) millimetres.emplace_back(1000 * point);
    ParameterSet parameters(preprocessParameters());
    ASSERT_TRUE(parameters.set("voxel_m", 0.3));
    const auto inMetres = preprocess(cloudOf(metres), parameters);
    const auto inMillimetres = preprocess(cloudOf(millimetres), parameters, 0.001);
    ASSERT_TRUE(inMetres && inMillimetres);
    EXPECT_NEAR(static_cast<double>(inMillimetres->size()), static_cast<double>(inMetres->size()),
                0.01 * static_cast<double>(inMetres->size()));
}

TEST(Preprocess, SaysTheRadiusItChose) {
    const PointCloud cloud = cloudOf(roughScene(10000, {0, 0, 0}));
    const ParameterSet automatic(preprocessParameters());
    const ParameterSet chosen = withChosenRadius(cloud, automatic);
    ASSERT_TRUE(chosen.optionalReal("radius_m"));
    EXPECT_NEAR(*chosen.optionalReal("radius_m"), 0.15, 0.03);
    std::string told;
    const JobControl control({}, [&](std::string_view text) { told = text; });
    const auto result = preprocess(cloud, automatic, 1, control);
    ASSERT_TRUE(result);
    EXPECT_TRUE(told.starts_with("neighbourhood radius: 0.1")) << told;
    expectIdentical(*result, *preprocess(cloud, chosen));

    ParameterSet none(preprocessParameters());
    ASSERT_TRUE(none.set("filter", std::string("none")));
    EXPECT_FALSE(withChosenRadius(cloud, none).optionalReal("radius_m"));
    expectIdentical(*preprocess(cloud, none), cloud);
}
