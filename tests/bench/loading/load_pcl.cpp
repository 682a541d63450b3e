// PCL's own reader on one file, in the layout of load_one's line: load_pcl FILE
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <chrono>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string file = argv[1];
    const auto begin = std::chrono::steady_clock::now();
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    const bool ply = file.ends_with(".ply");
    if ((ply ? pcl::io::loadPLYFile(file, cloud) : pcl::io::loadPCDFile(file, cloud)) != 0) return 3;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::cout << "pcl " << taken.count() << " s, " << cloud.size() << "\n";
    return 0;
}
