#include "core/measurement/fit/ScannerPath.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/measurement/fit/PlaneFit.h"

namespace vestige {
namespace {

constexpr double kPiece_s = 1;
constexpr std::size_t kMostPieces = 100'000;
constexpr std::size_t kMostBeams = 1500;  // of a piece
constexpr std::size_t kLeastBeams = 20;
constexpr double kLeastGap = 0.3;  // of the first and last echo of a pulse

struct Beam {
    Eigen::Vector3d point;
    Eigen::Vector3d direction;
    double weight;  // a gap twice as long tells the direction twice as well
    double time_s;  // from the middle of the piece
};

Eigen::Matrix<double, 3, 6> across(const Beam& beam) {
    const Eigen::Matrix3d projection =
        Eigen::Matrix3d::Identity() - beam.direction * beam.direction.transpose();
    Eigen::Matrix<double, 3, 6> rows;
    rows << projection, beam.time_s * projection;
    return rows;
}

/// Position and velocity at which the beams pass each other nearest, strays left out.
std::optional<Eigen::Matrix<double, 6, 1>> meetingOf(const std::vector<Beam>& beams) {
    Eigen::Matrix<double, 6, 1> found = Eigen::Matrix<double, 6, 1>::Zero();
    double scale = 0;
    for (int round = 0; round < 12; ++round) {
        Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
        Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
        for (const Beam& beam : beams) {
            const auto rows = across(beam);
            const Eigen::Vector3d value = rows.leftCols<3>() * beam.point;
            const double robust =
                round == 0 ? 1 : tukeyWeight((rows * found - value).norm() * beam.weight, scale);
            const double weight = robust * beam.weight * beam.weight;
            normal += weight * rows.transpose() * rows;
            right += weight * rows.transpose() * value;
        }
        // A weak hold on the velocity: a scanner flies at metres a second, not at hundreds.
        normal.bottomRightCorner<3, 3>() += 1e-6 * normal.trace() * Eigen::Matrix3d::Identity();
        const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal);
        if (solver.info() != Eigen::Success) return std::nullopt;
        found = solver.solve(right);
        std::vector<double> residuals;
        for (const Beam& beam : beams)
            residuals.push_back((across(beam) * found - across(beam).leftCols<3>() * beam.point).norm() *
                                beam.weight);
        scale = std::max(robustScale(std::move(residuals)), 1e-6);
        if (round < 11) continue;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> held(normal.topLeftCorner<3, 3>());
        // The scanner's place must be known to half a metre where it is known least.
        if (held.eigenvalues()[0] <= 0 || scale / std::sqrt(held.eigenvalues()[0]) > 0.5) return std::nullopt;
    }
    return found.allFinite() ? std::optional(found) : std::nullopt;
}

}  // namespace

std::optional<ScannerPath> ScannerPath::recovered(const PointCloud& cloud) {
    const PointAttributes& attributes = cloud.attributes();
    if (cloud.empty() || attributes.gpsTime.empty() || attributes.returnCount.empty()) return std::nullopt;
    const auto [first, last] = std::minmax_element(attributes.gpsTime.begin(), attributes.gpsTime.end());
    if (!std::isfinite(*first) || !std::isfinite(*last)) return std::nullopt;
    ScannerPath path;
    path.start_s_ = *first;
    const double pieces = std::floor((*last - *first) / kPiece_s) + 1;
    if (!(pieces <= static_cast<double>(kMostPieces))) return std::nullopt;
    path.pieces_.resize(static_cast<std::size_t>(pieces));

    // Pulses of several echoes: files keep a pulse's echoes together.
    std::vector<std::vector<std::size_t>> pairs(path.pieces_.size());
    for (std::size_t i = 0; i + 1 < cloud.size(); ++i) {
        if (attributes.returnCount[i] < 2 || attributes.gpsTime[i] != attributes.gpsTime[i + 1]) continue;
        if ((cloud.offsets()[i] - cloud.offsets()[i + 1]).norm() < static_cast<float>(kLeastGap)) continue;
        pairs[static_cast<std::size_t>((attributes.gpsTime[i] - path.start_s_) / kPiece_s)].push_back(i);
    }
    std::size_t known = 0;
    for (std::size_t piece = 0; piece < pairs.size(); ++piece) {
        const auto& here = pairs[piece];
        if (here.size() < kLeastBeams) continue;
        const double middle = path.start_s_ + (static_cast<double>(piece) + 0.5) * kPiece_s;
        const std::size_t step = here.size() / kMostBeams + 1;
        std::vector<Beam> beams;
        for (std::size_t k = 0; k < here.size(); k += step) {
            const Eigen::Vector3d a = cloud.point(here[k]) - cloud.origin();
            const Eigen::Vector3d way = cloud.point(here[k] + 1) - cloud.origin() - a;
            beams.push_back({a, way.normalized(), way.norm(), attributes.gpsTime[here[k]] - middle});
        }
        const auto found = meetingOf(beams);
        if (!found) continue;
        path.pieces_[piece] = {true, cloud.origin() + found->head<3>(), found->tail<3>()};
        ++known;
    }
    if (known == 0) return std::nullopt;
    path.times_ = attributes.gpsTime;
    return path;
}

std::optional<Eigen::Vector3d> ScannerPath::at(double time_s) const {
    const double place = (time_s - start_s_) / kPiece_s;
    if (!(place >= 0)) return std::nullopt;
    const auto piece = static_cast<std::size_t>(place);
    if (piece >= pieces_.size() || !pieces_[piece].known) return std::nullopt;
    const double middle = start_s_ + (static_cast<double>(piece) + 0.5) * kPiece_s;
    return pieces_[piece].position + (time_s - middle) * pieces_[piece].velocity;
}

}  // namespace vestige
