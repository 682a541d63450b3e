// Makes a large cloud of a real one: copies of it side by side, each moved by whole metres.
//   tile_cloud IN OUT.las|OUT.laz|OUT.ply|OUT.pcd POINTS
// PLY and PCD are written as other programs write them: binary, floats near the origin, colours as bytes.
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>

#include "core/io/FormatRegistry.h"
#include "core/io/LasWriter.h"

namespace {

using namespace vestige;

void writeFloats(const std::string& file, const std::vector<LasPart>& parts, std::uint64_t points) {
    std::ofstream out(file, std::ios::binary);
    const bool ply = file.ends_with(".ply");
    if (ply)
        out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points
            << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar "
               "green\n"
               "property uchar blue\nend_header\n";
    else
        out << "VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " << points
            << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points << "\nDATA binary\n";
    const std::size_t stride = ply ? 15 : 16;
    for (const LasPart& part : parts) {
        const PointCloud& cloud = *part.cloud;
        std::string records(stride * cloud.size(), '\0');
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector3f place =
                (part.worldFromCloud.pose.translation() + cloud.point(i) - cloud.bounds().min).cast<float>();
            const Color color = cloud.attributes().color.empty() ? Color{} : cloud.attributes().color[i];
            char* const at = records.data() + stride * i;
            std::memcpy(at, place.data(), 12);
            for (std::size_t channel = 0; channel < 3; ++channel)
                at[12 + (ply ? channel : 2 - channel)] = static_cast<char>(color[channel] >> 8);
        }
        out.write(records.data(), static_cast<std::streamsize>(records.size()));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: tile_cloud IN OUT.las|OUT.laz|OUT.ply|OUT.pcd POINTS\n";
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
    const std::uint64_t points = static_cast<std::uint64_t>(copies) * cloud.size();
    const std::string out = argv[2];
    if (out.ends_with(".ply") || out.ends_with(".pcd")) {
        writeFloats(out, parts, points);
        return 0;
    }
    LasWriteOptions options;
    options.scale = loaded->info.scale.value_or(Eigen::Vector3d::Constant(0.001));
    options.crsRecords = loaded->info.crsRecords;
    if (const Status written = writeLas(argv[2], parts, options); !written) {
        std::cerr << written.error().sentence() << "\n";
        return 5;
    }
    std::cerr << points << " points\n";
    return 0;
}
