#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sstream>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// What three_mf_truth.py reads of the file.
struct Truth {
    std::uint64_t vertices = 0, triangles = 0;
    Eigen::Vector3d low, high;
};

Truth truthOf(const std::filesystem::path& file) {
    const std::string command = "python3 '" VESTIGE_THREE_MF_TRUTH "' '" + file.string() + "'";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    char line[1024] = {};
    EXPECT_TRUE(pipe && std::fgets(line, sizeof(line), pipe.get())) << file;
    std::istringstream words(line);
    Truth truth;
    words >> truth.vertices >> truth.triangles;
    for (Eigen::Vector3d* corner : {&truth.low, &truth.high})
        for (double& value : *corner) words >> value;
    EXPECT_TRUE(words) << file;
    return truth;
}

}  // namespace

TEST(ThreeMf, EveryRealFileReadsAsAnIndependentReaderSays) {
    VESTIGE_SHARED_OR_SKIP(folder, "formats/3mf");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".3mf") continue;
        ++files;
        SCOPED_TRACE(entry.path());
        const Truth truth = truthOf(entry.path());
        const LoadedGeometry found = readOrFail(entry.path());
        EXPECT_EQ(found.info.points, truth.vertices);
        EXPECT_EQ(found.info.triangles, truth.triangles);
        // A cloud holds offsets from its origin as float.
        EXPECT_LT((found.info.bounds.min - truth.low).cwiseAbs().maxCoeff(), 1e-5);
        EXPECT_LT((found.info.bounds.max - truth.high).cwiseAbs().maxCoeff(), 1e-5);
        EXPECT_TRUE(found.info.metresPerUnit);
    }
    EXPECT_GE(files, 30);
}
