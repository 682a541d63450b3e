#include "core/registration/global/PoseFit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/registration/global/SmallTurn.h"

namespace vestige {
namespace {

constexpr float kSameDirection = 0.7F;

/// Cells on the faces of a half cube, 4 x 4 each.
constexpr int kFace = 4;

int directionCell(const Eigen::Vector3f& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const float along = normal[axis];
    const float a = normal[(axis + 1) % 3] / along;
    const float b = normal[(axis + 2) % 3] / along;
    const auto step = [](float x) {
        return std::clamp(static_cast<int>((x + 1) * 0.5F * kFace), 0, kFace - 1);
    };
    return (axis * kFace + step(a)) * kFace + step(b);
}

}  // namespace

std::vector<float> directionWeights(const Surfels& surfels) {
    std::array<std::uint32_t, 3 * kFace * kFace> counts{};
    for (const Eigen::Vector3f& normal : surfels.normals) ++counts[directionCell(normal)];
    std::vector<float> weights;
    weights.reserve(surfels.size());
    for (const Eigen::Vector3f& normal : surfels.normals)
        weights.push_back(1 / std::sqrt(static_cast<float>(counts[directionCell(normal)])));
    return weights;
}

PoseFit::PoseFit(const Surfels& source, std::vector<float> weights)
    : source_(source), weights_(std::move(weights)) {
    weights_.resize(source.size(), 1.0F);
    for (const float weight : weights_) total_ += weight;
}

double PoseFit::score(const SurfaceLookup& target, const Eigen::Isometry3d& pose, double tolerance_m) const {
    const Eigen::Isometry3f p = pose.cast<float>();
    const Surfels& surface = target.surfels();
    const auto perTolerance = static_cast<float>(1 / (tolerance_m * tolerance_m));
    double sum = 0;
    for (std::size_t i = 0; i < source_.size(); ++i) {
        const Eigen::Vector3f x = p * source_.points[i];
        const std::uint32_t at = target.near(x);
        if (at == SurfaceLookup::kNone) continue;
        const Eigen::Vector3f& normal = surface.normals[at];
        if (std::abs((p.linear() * source_.normals[i]).dot(normal)) < kSameDirection) continue;
        const float distance = normal.dot(x - surface.points[at]);
        sum += weights_[i] * std::max(0.0F, 1 - distance * distance * perTolerance);
    }
    return total_ > 0 ? sum / total_ : 0;
}

Eigen::Isometry3d PoseFit::refined(const SurfaceLookup& target, Eigen::Isometry3d pose, double tolerance_m,
                                   int steps) const {
    const Surfels& surface = target.surfels();
    for (int step = 0; step < steps; ++step) {
        const Eigen::Isometry3f p = pose.cast<float>();
        PlaneEquations equations;
        for (std::size_t i = 0; i < source_.size(); ++i) {
            const Eigen::Vector3f x = p * source_.points[i];
            const std::uint32_t at = target.near(x);
            if (at == SurfaceLookup::kNone) continue;
            const Eigen::Vector3f& normal = surface.normals[at];
            if (std::abs((p.linear() * source_.normals[i]).dot(normal)) < kSameDirection) continue;
            const double distance = normal.dot(x - surface.points[at]);
            const double share = distance / tolerance_m;
            const double inside = 1 - share * share;
            if (inside > 0) equations.add(x, normal, distance, weights_[i] * inside * inside);
        }
        const SmallTurn turn = equations.solve();
        pose = turn.pose * pose;
        if (turn.size < 1e-3 * tolerance_m) break;
    }
    return pose;
}

}  // namespace vestige
