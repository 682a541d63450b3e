#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sstream>

#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// What three_mf_truth.py reads of a file.
struct Truth {
    std::uint64_t vertices = 0, triangles = 0;
    Eigen::Vector3d low, high;
};

std::vector<Truth> truthOf(const std::vector<std::filesystem::path>& files) {
    std::string command = "python3 '" VESTIGE_THREE_MF_TRUTH "'";
    for (const auto& file : files) command += " '" + file.string() + "'";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::vector<Truth> truths;
    char line[1024] = {};
    while (pipe && std::fgets(line, sizeof(line), pipe.get())) {
        std::istringstream words(line);
        Truth& truth = truths.emplace_back();
        words >> truth.vertices >> truth.triangles;
        for (Eigen::Vector3d* corner : {&truth.low, &truth.high})
            for (double& value : *corner) words >> value;
        EXPECT_TRUE(words) << line;
    }
    return truths;
}

}  // namespace

TEST(ThreeMf, EveryRealFileReadsAsAnIndependentReaderSays) {
    VESTIGE_SHARED_OR_SKIP(folder, "formats/3mf");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".3mf") files.push_back(entry.path());
    EXPECT_GE(files.size(), 30);
    const std::vector<Truth> truths = truthOf(files);
    ASSERT_EQ(truths.size(), files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        SCOPED_TRACE(files[i]);
        const Truth& truth = truths[i];
        const LoadedGeometry found = readOrFail(files[i]);
        EXPECT_EQ(found.info.points, truth.vertices);
        EXPECT_EQ(found.info.triangles, truth.triangles);
        // A cloud holds offsets from its origin as float.
        EXPECT_LT((found.info.bounds.min - truth.low).cwiseAbs().maxCoeff(), 1e-5);
        EXPECT_LT((found.info.bounds.max - truth.high).cwiseAbs().maxCoeff(), 1e-5);
        EXPECT_TRUE(found.info.metresPerUnit);
    }
}
