// Open3D's own reader on one file, in the layout of load_one's line: load_open3d FILE
#include <open3d/io/PointCloudIO.h>

#include <chrono>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const auto begin = std::chrono::steady_clock::now();
    open3d::geometry::PointCloud cloud;
    if (!open3d::io::ReadPointCloud(argv[1], cloud)) return 3;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::cout << "open3d " << taken.count() << " s, " << cloud.points_.size() << "\n";
    return 0;
}
