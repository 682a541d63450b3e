#include "tests/core/io/Clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/base/AtomicFile.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige::test {
namespace {

template <class Values>
void expectSame(const Values& expected, const Values& found) {
    if (!found.empty()) {
        EXPECT_EQ(expected, found);
    }
}

}  // namespace

PointCloud fullCloud(std::size_t points, bool bytes) {
    Random random(7);
    PointCloudBuilder builder;
    PointAttributes& attributes = builder.attributes();
    for (std::size_t i = 0; i < points; ++i) {
        const auto millimetres = [&](double from, std::uint64_t range) {
            return (from * 1000 + static_cast<double>(random.below(range))) * 0.001;
        };
        builder.add({millimetres(576661, 900000), millimetres(5188114, 900000), millimetres(150, 30000)});
        attributes.intensity.push_back(static_cast<float>(random.below(65536)));
        const auto channel = [&] {
            return static_cast<std::uint16_t>(bytes ? 257 * random.below(256) : random.below(65536));
        };
        attributes.color.push_back({channel(), channel(), channel()});
        attributes.classification.push_back(static_cast<std::uint8_t>(random.below(256)));
        attributes.gpsTime.push_back(1e8 + 100 * random.uniform());
        attributes.normal.push_back(
            Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized().cast<float>());
        attributes.pointSource.push_back(static_cast<std::uint16_t>(random.below(65536)));
        attributes.returnCount.push_back(static_cast<std::uint8_t>(1 + random.below(5)));
        attributes.returnNumber.push_back(
            static_cast<std::uint8_t>(1 + random.below(attributes.returnCount.back())));
    }
    return std::move(builder).build();
}

LoadedGeometry readOrFail(const std::filesystem::path& file) {
    Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) return std::move(*loaded);
    ADD_FAILURE() << loaded.error().sentence();
    return {};
}

double largestDifference(const PointCloud& a, const PointCloud& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, (a.point(i) - b.point(i)).cwiseAbs().maxCoeff());
    return largest;
}

void expectSameAttributes(const PointCloud& a, const PointCloud& b) {
    const PointAttributes& x = a.attributes();
    const PointAttributes& y = b.attributes();
    expectSame(x.intensity, y.intensity);
    expectSame(x.color, y.color);
    expectSame(x.classification, y.classification);
    expectSame(x.gpsTime, y.gpsTime);
    expectSame(x.normal, y.normal);
    expectSame(x.pointSource, y.pointSource);
    expectSame(x.returnNumber, y.returnNumber);
    expectSame(x.returnCount, y.returnCount);
}

void writeBytes(const std::filesystem::path& file, std::string_view content) {
    std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

std::string readBytes(const std::filesystem::path& file) {
    Result<std::string> text = readTextFile(file);
    EXPECT_TRUE(text) << text.error().sentence();
    return text ? *text : std::string();
}

}  // namespace vestige::test
