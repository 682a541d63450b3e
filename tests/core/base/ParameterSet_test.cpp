#include "core/base/ParameterSet.h"

#include <gtest/gtest.h>

using namespace vestige;

namespace {

const ParameterTable& table() {
    static const ParameterTable specs{
        {"voxel_m", "voxel", "Voxel", "m", ParameterType::real, std::monostate{}, 0.01, 100.0, {}, "Size."},
        {"filter",
         "filter",
         "Filter",
         "",
         ParameterType::choice,
         std::string("mean"),
         {},
         {},
         {"mean", "median"},
         "Kind."},
        {"count", "count", "Count", "", ParameterType::integer, std::int64_t{8}, 1.0, {}, {}, "Number."},
    };
    return specs;
}

}  // namespace

TEST(ParameterSet, KeepsDefaultsUntilSet) {
    ParameterSet set(table());
    EXPECT_FALSE(set.optionalReal("voxel_m"));
    EXPECT_EQ(set.display("voxel_m"), "automatic");
    ASSERT_TRUE(set.setFromText("voxel_m", "0.25"));
    EXPECT_EQ(set.real("voxel_m"), 0.25);
    EXPECT_EQ(set.display("voxel_m"), "0.25 m");
    EXPECT_FALSE(set.isDefault("voxel_m"));
    ASSERT_TRUE(set.setFromText("voxel_m", "auto"));
    EXPECT_TRUE(set.isDefault("voxel_m"));
}

TEST(ParameterSet, RefusesWhatTheSpecDoesNotAllowAndSaysWhatItDoes) {
    ParameterSet set(table());
    for (const char* bad : {"0.001", "1e9", "nan", "x", ""}) {
        const Status status = set.setFromText("voxel_m", bad);
        ASSERT_FALSE(status) << bad;
        EXPECT_EQ(status.error().code, ErrorCode::usage);
        EXPECT_NE(status.error().hint.find("0.01"), std::string::npos);
    }
    EXPECT_FALSE(set.setFromText("filter", "max"));
    EXPECT_FALSE(set.setFromText("count", "1.5"));
    EXPECT_FALSE(set.setFromText("count", "0"));
    EXPECT_FALSE(set.set("none", 1.0));
}
