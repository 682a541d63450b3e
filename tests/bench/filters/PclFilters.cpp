#include "tests/bench/filters/PclFilters.h"

#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace vestige {

struct PclFilters::Cloud {
    pcl::PointCloud<pcl::PointXYZ>::Ptr points{new pcl::PointCloud<pcl::PointXYZ>};
};

PclFilters::PclFilters(const PointCloud& cloud) : cloud_(std::make_unique<Cloud>()) {
    for (const Eigen::Vector3f& offset : cloud.offsets())
        cloud_->points->push_back({offset.x(), offset.y(), offset.z()});
}
PclFilters::~PclFilters() = default;

std::size_t PclFilters::voxelGrid(float size, bool allFields) const {
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud_->points);
    grid.setLeafSize(size, size, size);
    grid.setDownsampleAllData(allFields);
    pcl::PointCloud<pcl::PointXYZ> thin;
    grid.filter(thin);
    return thin.size();
}

double PclFilters::meanFilter(float radius) const {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
    tree.setInputCloud(cloud_->points);
    double height = 0;
    std::vector<int> found;
    std::vector<float> distances;
    for (const pcl::PointXYZ& point : *cloud_->points) {
        tree.radiusSearch(point, radius, found, distances);
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (const int other : found)
            sum += (*cloud_->points)[static_cast<std::size_t>(other)].getVector3fMap();
        height += static_cast<double>((sum / static_cast<float>(found.size())).z());
    }
    return height;
}

std::vector<std::int32_t> PclFilters::statistical(int neighbours, double sigmas) const {
    pcl::StatisticalOutlierRemoval<pcl::PointXYZ> removal;
    removal.setInputCloud(cloud_->points);
    removal.setMeanK(neighbours);
    removal.setStddevMulThresh(sigmas);
    pcl::Indices kept;
    removal.filter(kept);
    return kept;
}

}  // namespace vestige
