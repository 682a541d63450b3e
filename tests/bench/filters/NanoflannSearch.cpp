#include "tests/bench/filters/NanoflannSearch.h"

#include <cstdint>
#include <nanoflann.hpp>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

struct Points {
    const std::vector<Eigen::Vector3f>& offsets;

    std::size_t kdtree_get_point_count() const { return offsets.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return offsets[i][static_cast<int>(axis)]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

}  // namespace

struct NanoflannSearch::Tree {
    using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3>;

    explicit Tree(const PointCloud& cloud)
        : points{cloud.offsets()}, index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {
        index.buildIndex();
    }
    Points points;
    Index index;
};

NanoflannSearch::NanoflannSearch(const PointCloud& cloud) : tree_(std::make_unique<Tree>(cloud)) {}
NanoflannSearch::~NanoflannSearch() = default;

double NanoflannSearch::nearestOfAll(std::size_t count) const {
    const auto& offsets = tree_->points.offsets;
    return parallelSum(offsets.size(), 4096, 0.0, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> found(count);
        std::vector<float> squared(count);
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            tree_->index.knnSearch(offsets[i].data(), count, found.data(), squared.data());
            sum += static_cast<double>(squared.back());
        }
        return sum;
    });
}

}  // namespace vestige
