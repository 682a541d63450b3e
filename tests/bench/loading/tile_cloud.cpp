// Makes a large cloud of a real one: copies of it side by side, each moved by whole metres.
//   tile_cloud IN OUT.las|OUT.laz POINTS
#include <cmath>
#include <iostream>
#include <string>

#include "core/io/FormatRegistry.h"
#include "core/io/LasWriter.h"

int main(int argc, char** argv) {
    using namespace vestige;
    if (argc != 4) {
        std::cerr << "usage: tile_cloud IN OUT.las|OUT.laz POINTS\n";
        return 2;
    }
    const auto loaded = readGeometry(argv[1]);
    if (!loaded) {
        std::cerr << loaded.error().sentence() << "\n";
        return 3;
    }
    const PointCloud& cloud = loaded->geometry.vertices;
    const auto copies = static_cast<int>(std::ceil(std::stod(argv[3]) / static_cast<double>(cloud.size())));
    const int side = static_cast<int>(std::ceil(std::sqrt(copies)));
    const Eigen::Vector3d extent = cloud.bounds().extent().array().ceil().matrix();
    std::vector<LasPart> parts;
    for (int i = 0; i < copies; ++i) {
        Similarity motion;
        motion.pose.translation() = Eigen::Vector3d(i % side * extent.x(), i / side * extent.y(), 0);
        parts.push_back({&cloud, motion, static_cast<std::uint16_t>(i + 1)});
    }
    LasWriteOptions options;
    options.scale = loaded->info.scale.value_or(Eigen::Vector3d::Constant(0.001));
    options.crsRecords = loaded->info.crsRecords;
    if (const Status written = writeLas(argv[2], parts, options); !written) {
        std::cerr << written.error().sentence() << "\n";
        return 5;
    }
    std::cerr << static_cast<std::uint64_t>(copies) * cloud.size() << " points\n";
    return 0;
}
