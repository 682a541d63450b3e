#include "core/registration/SourceLevels.h"

#include <algorithm>

namespace vestige {
namespace {

constexpr double kPointsPerVoxel = 4;

std::vector<Eigen::Vector3f> means(const std::vector<CellMoments>& cells) {
    std::vector<Eigen::Vector3f> points;
    points.reserve(cells.size());
    for (const CellMoments& cell : cells) points.emplace_back(cell.mean[0], cell.mean[1], cell.mean[2]);
    return points;
}

}  // namespace

SourceLevels::SourceLevels(const RegistrationFrame& frame, double leaf, double largest)
    : frame_(frame), leaf_(leaf), stages_(frame.source(), leaf, largest) {
    const auto points = static_cast<double>(frame.source().size());
    while (2 * leaf_ <= largest * (1 + 1e-9) &&
           kPointsPerVoxel * static_cast<double>(stages_.stage(VoxelGrid(leaf_))->size()) > points)
        leaf_ *= 2;
}

CentredSource SourceLevels::at(double size) const {
    const VoxelGrid grid(std::max(size, leaf_));
    const std::vector<CellMoments>* const stage = stages_.stage(grid);
    return frame_.centred(means(stage != nullptr ? *stage : stages_.at(grid)));
}

}  // namespace vestige
