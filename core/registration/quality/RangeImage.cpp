#include "core/registration/quality/RangeImage.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kMostRays = 200000;
constexpr double kRaysPerPixel = 1.5;
constexpr int kLargestSide = 256;
constexpr double kReach = 1.5;   // standard deviations of a cell: nearly all of a filled rectangle
constexpr double kAskew = 0.15;  // cosine to the ray: a ray that grazes a surface says little of it
constexpr double kWidest = 0.5;  // of the distance: a larger piece is too near to the viewpoint
constexpr std::size_t kMostInWindow = 400;  // rays looked at for one piece
constexpr double kShortest = 0.02;          // m; some files hold directions without a return as zeros

struct FacePlace {
    int face;
    double u, v;
};

FacePlace faceOf(const Eigen::Vector3d& ray) {
    Eigen::Index axis = 0;
    const double largest = ray.cwiseAbs().maxCoeff(&axis);
    const int face = static_cast<int>(2 * axis) + (ray[axis] < 0 ? 1 : 0);
    return {face, ray[(axis + 1) % 3] / largest, ray[(axis + 2) % 3] / largest};
}

int pixelAlong(double u, int side) {
    return std::clamp(static_cast<int>(std::floor((u + 1) / 2 * side)), 0, side - 1);
}

}  // namespace

RangeImage::RangeImage(std::span<const Eigen::Vector3f> points, const Eigen::Vector3d& viewpoint)
    : viewpoint_(viewpoint) {
    const std::size_t stride = points.size() / kMostRays + 1;
    const std::size_t rays = points.size() / stride;
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(rays) / (6 * kRaysPerPixel))), 8,
                       kLargestSide);
    std::vector<std::uint32_t> pixels(rays);
    constexpr std::size_t kGrain = 16384;
    parallelFor(rays, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const FacePlace place = faceOf(points[i * stride].cast<double>() - viewpoint);
            pixels[i] = static_cast<std::uint32_t>((place.face * side_ + pixelAlong(place.v, side_)) * side_ +
                                                   pixelAlong(place.u, side_));
        }
    });
    begins_.assign(static_cast<std::size_t>(6 * side_ * side_) + 1, 0);
    for (const std::uint32_t pixel : pixels) ++begins_[pixel + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    points_.resize(rays);
    for (std::size_t i = 0; i < rays; ++i)
        points_[next[pixels[i]]++] = (points[i * stride].cast<double>() - viewpoint).cast<float>();
}

RayCounts RangeImage::meeting(const SurfaceCell& cell, double margin_m) const {
    const Eigen::Vector3d middle = cell.mean - viewpoint_;
    const double range = middle.norm();
    const double height = cell.normal.dot(middle);  // of the plane over the viewpoint, along the normal
    const double radius = kReach * cell.wide_m;
    if (!(std::abs(height) > kAskew * range) || radius > kWidest * range) return {};
    const Eigen::Vector3d direction = middle / range;
    const Eigen::Vector3d along = cell.wide / (kReach * cell.wide_m);
    const Eigen::Vector3d across = cell.wide.cross(cell.normal) / (kReach * cell.narrow_m);
    const double spread = radius / range;  // at least the tangent of the angle to the rim
    const double side = height < 0 ? -1 : 1;
    struct Span {
        std::uint32_t begin, end;
    };
    std::vector<Span> window;
    std::size_t rays = 0;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double depth = face % 2 == 0 ? direction[axis] : -direction[axis];
        if (depth < 0.2) continue;
        const double u = direction[(axis + 1) % 3] / depth;
        const double v = direction[(axis + 2) % 3] / depth;
        const double off = std::sqrt(u * u + v * v);
        // A cone's outline on the face, generously.
        const double tangent = spread / std::sqrt(std::max(0.05, 1 - spread * spread));
        const double slack = 1 - tangent * off;
        const double half = slack > 0.1 ? tangent * (1 + off * off) / slack : 2;
        if (u - half > 1 || u + half < -1 || v - half > 1 || v + half < -1) continue;
        const int right = pixelAlong(u + half, side_);
        const int top = pixelAlong(v + half, side_);
        for (int row = pixelAlong(v - half, side_); row <= top; ++row) {
            const std::size_t line = static_cast<std::size_t>((face * side_ + row) * side_);
            const std::uint32_t end = begins_[line + static_cast<std::size_t>(right) + 1];
            const std::uint32_t begin = begins_[line + static_cast<std::size_t>(pixelAlong(u - half, side_))];
            if (begin < end) window.push_back({begin, end});
            rays += end - begin;
        }
    }
    RayCounts counts;
    const std::size_t stride = rays / kMostInWindow + 1;
    std::size_t skip = 0;
    for (const Span& span : window) {
        std::size_t i = span.begin + skip;
        for (; i < span.end; i += stride) {
            const Eigen::Vector3d ray = points_[i].cast<double>();
            const double reach = cell.normal.dot(ray);
            if (!(reach * side > 0) || ray.squaredNorm() < kShortest * kShortest) continue;
            const Eigen::Vector3d offset = height / reach * ray - middle;  // where it meets the plane
            const double x = offset.dot(along);
            const double y = offset.dot(across);
            if (x * x + y * y > 1) continue;
            const double beyond = (reach - height) * side;
            ++(beyond > margin_m ? counts.behind : beyond < -margin_m ? counts.before : counts.on);
        }
        skip = i - span.end;
    }
    return counts;
}

}  // namespace vestige
