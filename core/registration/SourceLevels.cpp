#include "core/registration/SourceLevels.h"

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
    : frame_(frame), leaf_(leaf), finest_(gatherPoints(frame.source(), VoxelGrid(leaf))) {
    const auto points = static_cast<double>(frame.source().size());
    while (kPointsPerVoxel * static_cast<double>(finest_.size()) > points &&
           2 * leaf_ <= largest * (1 + 1e-9)) {
        leaf_ *= 2;
        finest_ = gatherCells(finest_, VoxelGrid(leaf_));
    }
}

CentredSource SourceLevels::at(double size) const {
    return frame_.centred(size > leaf_ ? means(gatherCells(finest_, VoxelGrid(size))) : means(finest_));
}

}  // namespace vestige
