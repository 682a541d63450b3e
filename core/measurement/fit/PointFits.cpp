#include "core/measurement/fit/PointFits.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/measurement/fit/ExtremeFit.h"

namespace vestige {

std::optional<PlaceFit> cornerAtSeed(const Neighbourhood& near) {
    const std::vector<PlaneFit> planes = findPlanes(near, 4);
    const double clear = std::max(1.2 * near.noise_m, 1.5 * near.spacing_m);
    const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
    std::optional<PlaceFit> best;
    double nearest = 0.6 * near.radius_m;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                std::array<PlaneFit, 3> three{planes[i], planes[j], planes[k]};
                PlaceFit corner;
                bool good = true;
                for (int round = 0; good && round < 3; ++round) {
                    Eigen::Matrix3d system;
                    Eigen::Vector3d right;
                    Eigen::Vector3d variance;
                    for (int row = 0; row < 3; ++row) {
                        const PlaneFit& plane = three[static_cast<std::size_t>(row)];
                        system.row(row) = plane.normal.transpose();
                        right[row] = plane.normal.dot(plane.centre);
                    }
                    // Below this no place is held in some direction.
                    if (std::abs(system.determinant()) < 0.2) {
                        good = false;
                        break;
                    }
                    const Eigen::Matrix3d inverse = system.inverse();
                    corner.place = inverse * right;
                    corner.inliers = 0;
                    double squares = 0;
                    for (int row = 0; row < 3; ++row) {
                        const PlaneFit& plane = three[static_cast<std::size_t>(row)];
                        variance[row] = plane.varianceAt(corner.place);
                        corner.inliers += plane.inliers;
                        squares += plane.rms * plane.rms / 3;
                    }
                    corner.rms = std::sqrt(squares);
                    corner.covariance = inverse * variance.asDiagonal() * inverse.transpose();
                    if (corner.place.norm() >= nearest) good = false;
                    // Near the other two planes points are mixed of both.
                    for (std::size_t row = 0; good && row < 3; ++row) {
                        std::vector<FitPoint> own;
                        for (const FitPoint& point : near.points) {
                            bool clean = true;
                            for (std::size_t other = 0; other < 3; ++other)
                                clean = clean && (other == row ||
                                                  std::abs(three[other].distance(point.position)) > clear);
                            if (clean) own.push_back(point);
                        }
                        const auto fit = refinePlane(own, three[row], noise);
                        if (!fit)
                            good = false;
                        else
                            three[row] = *fit;
                    }
                }
                if (!good) continue;
                nearest = corner.place.norm();
                best = corner;
            }
        }
    }
    return best;
}

std::optional<PlaceFit> extremeAlong(const Neighbourhood& near, const Eigen::Vector3d& upwards) {
    std::vector<double> heights;
    for (const FitPoint& point : near.points) heights.push_back(upwards.dot(point.position));
    const double noise = std::max(near.noise_m, 0.2 * near.spacing_m);
    const auto end = upperEnd(heights, noise);
    if (!end) return std::nullopt;
    PlaceFit fit;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i] < end->place - 1.5 * noise || heights[i] > end->place + 3 * noise) continue;
        const Eigen::Vector3d aside = near.points[i].position - heights[i] * upwards;
        sum += aside;
        squares += aside * aside.transpose();
        ++fit.inliers;
    }
    if (fit.inliers < 3) return std::nullopt;
    const auto n = static_cast<double>(fit.inliers);
    fit.place = sum / n + end->place * upwards;
    fit.covariance = (squares / n - sum * sum.transpose() / (n * n)) / n +
                     end->standardUncertainty * end->standardUncertainty * upwards * upwards.transpose();
    fit.rms = near.noise_m;
    return fit;
}

std::optional<PlaceFit> centroidAtSeed(const Neighbourhood& near) {
    if (near.points.size() < 3) return std::nullopt;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double scale = near.radius_m;
    PlaceFit fit;
    for (int round = 0; round < 10; ++round) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double weights = 0;
        std::vector<double> distances;
        for (const FitPoint& point : near.points) {
            const double distance = (point.position - middle).norm();
            distances.push_back(distance);
            const double weight = tukeyWeight(distance, scale);
            sum += weight * point.position;
            weights += weight;
        }
        middle = sum / weights;
        scale = std::max(robustScale(std::move(distances)), near.noise_m + near.spacing_m);
    }
    fit.place = middle;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    double weights = 0;
    for (const FitPoint& point : near.points) {
        const Eigen::Vector3d from = point.position - middle;
        const double weight = tukeyWeight(from.norm(), scale);
        if (weight <= 0) continue;
        ++fit.inliers;
        weights += weight;
        scatter += weight * from * from.transpose();
    }
    fit.covariance = scatter / (weights * weights);
    fit.rms = std::sqrt(scatter.trace() / weights);
    return fit;
}

}  // namespace vestige
