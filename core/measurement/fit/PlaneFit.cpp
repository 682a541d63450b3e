#include "core/measurement/fit/PlaneFit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vestige {
namespace {

constexpr double kTukey = 4.685;
constexpr std::size_t kLeastPoints = 6;

/// Directions spread evenly over the half sphere (a Fibonacci lattice), about 8 degrees apart.
const std::vector<Eigen::Vector3d>& directions() {
    static const std::vector<Eigen::Vector3d> all = [] {
        constexpr int kCount = 400;
        std::vector<Eigen::Vector3d> list;
        for (int i = 0; i < kCount; ++i) {
            const double z = (i + 0.5) / kCount;
            const double turn = 2 * std::numbers::pi * std::numbers::phi * i;
            const double r = std::sqrt(1 - z * z);
            list.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
        }
        return list;
    }();
    return all;
}

struct Hypothesis {
    double score = 0;
    Eigen::Vector3d normal;
    double offset = 0;
};

/// The offset along `normal` within +-reach at which most points lie, of bins half as wide as the noise.
Hypothesis bestOffset(std::span<const FitPoint> points, const Eigen::Vector3d& normal, double reach,
                      double bin, std::vector<double>& counts) {
    const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
    counts.assign(bins + 4, 0);
    for (const FitPoint& point : points) {
        const double at = (normal.dot(point.position) + reach) / bin;
        if (at < 0 || at >= static_cast<double>(bins)) continue;
        counts[static_cast<std::size_t>(at) + 2] += 1;
    }
    Hypothesis best{-1, normal, 0};
    for (std::size_t i = 2; i < bins + 2; ++i) {
        const double score =
            counts[i] + 0.85 * (counts[i - 1] + counts[i + 1]) + 0.4 * (counts[i - 2] + counts[i + 2]);
        if (score > best.score) {
            best.score = score;
            best.offset = (static_cast<double>(i) - 1.5) * bin - reach;
        }
    }
    return best;
}

/// Refits planes that were found one after the other together: each to the points that lie nearest to it. The
/// first ones had taken points of the later ones and leaned towards them.
void shareOut(std::span<const FitPoint> points, std::vector<PlaneFit>& planes, double noise, double least) {
    if (planes.size() < 2) return;
    for (int round = 0; round < 10; ++round) {
        std::vector<std::vector<FitPoint>> own(planes.size());
        for (const FitPoint& point : points) {
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < planes.size(); ++i)
                if (std::abs(planes[i].distance(point.position)) <
                    std::abs(planes[nearest].distance(point.position)))
                    nearest = i;
            own[nearest].push_back(point);
        }
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const auto fit = refinePlane(own[i], planes[i], noise);
            if (fit)
                planes[i] = *fit;
            else
                planes[i].support = 0;
        }
        std::erase_if(planes, [&](const PlaneFit& plane) { return plane.support < 0.5 * least; });
    }
}

}  // namespace

double PlaneFit::varianceAt(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = axes.transpose() * (point - centre);
    return variance[2] + from[0] * from[0] * variance[0] + from[1] * from[1] * variance[1];
}

double tukeyWeight(double residual, double scale) {
    const double x = residual / (kTukey * scale);
    if (std::abs(x) >= 1) return 0;
    const double y = 1 - x * x;
    return y * y;
}

double robustScale(std::vector<double> residuals) {
    if (residuals.empty()) return 0;
    for (double& residual : residuals) residual = std::abs(residual);
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return 1.4826 * *middle;
}

std::optional<PlaneFit> refinePlane(std::span<const FitPoint> points, const PlaneFit& start, double noise_m) {
    // Another surface is often nearer than the 4.7 scales at which the biweight usually ends.
    constexpr double kEnd = 3.2;
    PlaneFit plane = start;
    double scale = noise_m;
    std::vector<double> weights(points.size());
    const auto weigh = [&] {
        plane.inliers = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            weights[i] = tukeyWeight(plane.distance(points[i].position), scale * kEnd / kTukey);
            if (weights[i] > 0) ++plane.inliers;
        }
    };
    for (int round = 0; round < 40; ++round) {
        weigh();
        if (plane.inliers < kLeastPoints) return std::nullopt;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            sum += weights[i];
            mean += weights[i] * points[i].position;
        }
        mean /= sum;
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (weights[i] <= 0) continue;
            const Eigen::Vector3d d = points[i].position - mean;
            scatter += weights[i] * d * d.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
        if (solver.eigenvalues()[1] < 1.5 * solver.eigenvalues()[0]) return std::nullopt;
        const Eigen::Vector3d before = plane.normal;
        plane.centre = mean;
        plane.normal = solver.eigenvectors().col(0);
        if (plane.normal.dot(before) < 0) plane.normal = -plane.normal;
        plane.axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1), plane.normal;
        // The noise lies along the beam; across the surface it is smaller, never larger.
        std::vector<double> residuals;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (weights[i] > 0) residuals.push_back(plane.distance(points[i].position));
        scale = std::clamp(robustScale(std::move(residuals)), 0.4 * noise_m, noise_m);
        if (round > 3 && (plane.normal - before).norm() < 1e-7) break;
    }
    // Variances of an M-estimate: sum of psi^2 over the squared sum of psi', along each parameter.
    weigh();
    double squares = 0;
    Eigen::Vector3d scores = Eigen::Vector3d::Zero();
    Eigen::Vector3d slopes = Eigen::Vector3d::Zero();
    plane.support = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (weights[i] <= 0) continue;
        const Eigen::Vector3d from = plane.axes.transpose() * (points[i].position - plane.centre);
        const double x = from[2] / (kEnd * scale);
        const Eigen::Vector3d row(from[0], from[1], 1);
        scores += (weights[i] * from[2] * row).cwiseAbs2();
        slopes += (1 - x * x) * (1 - 5 * x * x) * row.cwiseAbs2();
        squares += weights[i] * from[2] * from[2];
        plane.support += weights[i];
    }
    if (!(slopes.minCoeff() > 0)) return std::nullopt;
    plane.rms = std::sqrt(squares / plane.support);
    const double few = plane.support / std::max(1.0, plane.support - 3);
    plane.variance = few * scores.cwiseQuotient(slopes.cwiseAbs2());
    return plane;
}

std::vector<PlaneFit> findPlanes(const Neighbourhood& near, std::size_t most, double leastShare) {
    std::vector<FitPoint> left = near.points;
    const auto least =
        std::max(static_cast<double>(kLeastPoints), leastShare * static_cast<double>(left.size()));
    const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
    std::vector<PlaneFit> planes;
    std::vector<double> counts;
    while (planes.size() < most && static_cast<double>(left.size()) >= least) {
        std::vector<Hypothesis> hypotheses;
        // A direction of the lattice is up to 4 degrees off: across the radius that is as wide as this.
        const double bin = std::max(0.5 * noise, 0.04 * near.radius_m);
        for (const Eigen::Vector3d& direction : directions())
            hypotheses.push_back(bestOffset(left, direction, near.radius_m, bin, counts));
        std::stable_sort(hypotheses.begin(), hypotheses.end(),
                         [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
        std::optional<PlaneFit> best;
        for (std::size_t i = 0; i < std::min<std::size_t>(6, hypotheses.size()); ++i) {
            PlaneFit start;
            start.normal = hypotheses[i].normal;
            start.centre = hypotheses[i].offset * start.normal;
            // Coarse first: the lattice's tilt would cut the plane's own points off.
            const auto coarse = refinePlane(left, start, std::max(noise, 0.5 * bin));
            const auto fit = coarse ? refinePlane(left, *coarse, noise) : std::nullopt;
            if (fit && (!best || fit->support > best->support)) best = fit;
        }
        if (!best || best->support < least) break;
        const double reach = 2.5 * std::max(best->rms, 0.3 * noise);
        std::erase_if(left, [&](const FitPoint& p) { return std::abs(best->distance(p.position)) < reach; });
        if (best->normal.dot(near.view) > 0) {
            best->normal = -best->normal;
            best->axes.col(2) = best->normal;
        }
        planes.push_back(*best);
    }
    shareOut(near.points, planes, noise, least);
    return planes;
}

std::optional<PlaneFit> planeAtSeed(const Neighbourhood& near) {
    const double noise = std::max(near.noise_m, 0.05 * near.spacing_m);
    std::optional<PlaneFit> best;
    double most = 0;
    // A small thing has no room for the whole radius: its own plane is found in half of it. The larger one is
    // the surer where both say the same.
    for (const double share : {1.0, 0.5}) {
        const Neighbourhood part =
            share < 1 ? near.within(Eigen::Vector3d::Zero(), share * near.radius_m) : near;
        for (const PlaneFit& found : findPlanes(part, 4)) {
            const auto plane = refinePlane(part.points, found, noise);
            if (!plane) continue;
            // Where the view meets it, or the foot from the seed where it is seen at a grazing angle.
            const double slant = plane->normal.dot(near.view);
            const double away = plane->distance(Eigen::Vector3d::Zero());
            Eigen::Vector3d place = plane->project(Eigen::Vector3d::Zero());
            if (std::abs(slant) > 0.2) place = away / -slant * near.view;
            const double off = std::abs(away) / (1.5 * noise + 0.5 * near.spacing_m);
            double sum = 0;
            for (const FitPoint& point : near.points)
                if ((point.position - place).norm() < 0.3 * near.radius_m)
                    sum += tukeyWeight(plane->distance(point.position), noise);
            sum *= std::exp(-0.5 * off * off) * (share < 1 ? 0.8 : 1);
            if (sum <= most) continue;
            most = sum;
            best = plane;
        }
    }
    return best;
}

}  // namespace vestige
