#include "core/registration/SourceLevels.h"

namespace vestige {
namespace {

std::vector<Eigen::Vector3f> means(const std::vector<CellMoments>& cells) {
    std::vector<Eigen::Vector3f> points;
    points.reserve(cells.size());
    for (const CellMoments& cell : cells) points.emplace_back(cell.mean[0], cell.mean[1], cell.mean[2]);
    return points;
}

}  // namespace

SourceLevels::SourceLevels(const RegistrationFrame& frame, double leaf)
    : frame_(frame), leaf_(leaf), finest_(gatherPoints(frame.source(), VoxelGrid(leaf))) {}

CentredSource SourceLevels::at(double size) const {
    return frame_.centred(size > leaf_ ? means(gatherCells(finest_, VoxelGrid(size))) : means(finest_));
}

}  // namespace vestige
