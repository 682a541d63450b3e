#include "core/measurement/kinds/CircleThrough.h"

#include <Eigen/Dense>
#include <cmath>
#include <optional>

namespace vestige {
namespace {

struct Algebraic {
    Eigen::Vector2d centre;
    double radius;
};

/// Points are centred and of a size about 1.
std::optional<Algebraic> taubin(const Eigen::MatrixX2d& p) {
    const auto n = static_cast<double>(p.rows());
    double xx = 0, yy = 0, xy = 0, xz = 0, yz = 0, zz = 0;
    for (Eigen::Index i = 0; i < p.rows(); ++i) {
        const double x = p(i, 0), y = p(i, 1), z = x * x + y * y;
        xx += x * x / n;
        yy += y * y / n;
        xy += x * y / n;
        xz += x * z / n;
        yz += y * z / n;
        zz += z * z / n;
    }
    const double z = xx + yy;
    const double area = xx * yy - xy * xy;
    const double spread = zz - z * z;
    const double a3 = 4 * z;
    const double a2 = -3 * z * z - zz;
    const double a1 = spread * z + 4 * area * z - xz * xz - yz * yz;
    const double a0 = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - spread * area;
    double root = 0;
    for (int i = 0; i < 99; ++i) {
        const double slope = a1 + root * (2 * a2 + root * 3 * a3);
        const double next = root - (a0 + root * (a1 + root * (a2 + root * a3))) / slope;
        if (!std::isfinite(next) || next == root) break;
        root = next;
    }
    const double det = root * root - root * z + area;
    if (!(std::abs(det) > 1e-14)) return std::nullopt;
    const Eigen::Vector2d centre(0.5 * (xz * (yy - root) - yz * xy) / det,
                                 0.5 * (yz * (xx - root) - xz * xy) / det);
    const double radius = std::sqrt(centre.squaredNorm() + z);
    if (!std::isfinite(radius)) return std::nullopt;
    return Algebraic{centre, radius};
}

/// A, D and the angle t; residuals are signed distances.
struct Regular {
    Eigen::Vector3d value;

    double e() const { return std::sqrt(std::max(0.0, 1 + 4 * value[0] * value[1])); }

    void residuals(const Eigen::MatrixX2d& p, Eigen::VectorXd& d, Eigen::MatrixX3d& jacobian) const {
        const double a = value[0], dd = value[1], c = std::cos(value[2]), s = std::sin(value[2]);
        const double edge = e();
        for (Eigen::Index i = 0; i < p.rows(); ++i) {
            const double x = p(i, 0), y = p(i, 1), z = x * x + y * y;
            const double u = x * c + y * s;
            const double value_ = a * z + edge * u + dd;
            const double q = std::sqrt(std::max(0.0, 1 + 4 * a * value_));
            const double distance = 2 * value_ / (1 + q);
            const double r = 2 * (1 - a * distance / q) / (q + 1);
            d[i] = distance;
            jacobian(i, 0) = (z + 2 * dd * u / edge) * r - distance * distance / q;
            jacobian(i, 1) = (2 * a * u / edge + 1) * r;
            jacobian(i, 2) = (-x * s + y * c) * edge * r;
        }
    }
};

Regular regular(const Algebraic& start) {
    const double a = 1 / (2 * start.radius);
    const double b = -2 * a * start.centre.x(), c = -2 * a * start.centre.y();
    return {{a, (b * b + c * c - 1) / (4 * a), std::atan2(c, b)}};
}

}  // namespace

Result<CircleThrough> circleThrough(std::span<const Eigen::Vector2d> points) {
    if (points.size() < 3) return fail(ErrorCode::input, "a circle needs three points");
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixX2d p(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) p.row(i) = points[static_cast<std::size_t>(i)].transpose();
    const Eigen::RowVector2d middle = p.colwise().mean();
    p.rowwise() -= middle;
    const double size = std::sqrt(p.squaredNorm() / static_cast<double>(n));
    if (!(size > 0)) return fail(ErrorCode::input, "the points of the circle are one and the same");
    p /= size;
    const auto start = taubin(p);
    if (!start || start->radius > 1e7)
        return fail(ErrorCode::input, "the points of the circle lie on one line");

    Regular fit = regular(*start);
    Eigen::VectorXd d(n), tried(n);
    Eigen::MatrixX3d jacobian(n, 3), other(n, 3);
    fit.residuals(p, d, jacobian);
    double damping = 1e-6;
    for (int i = 0; i < 100; ++i) {
        Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
        const Eigen::Vector3d slope = jacobian.transpose() * d;
        normal.diagonal() *= 1 + damping;
        const Eigen::Vector3d step = normal.ldlt().solve(-slope);
        const Regular next{fit.value + step};
        next.residuals(p, tried, other);
        if (!(tried.squaredNorm() <= d.squaredNorm())) {
            damping *= 10;
            if (damping > 1e8) break;
            continue;
        }
        fit = next;
        std::swap(d, tried);
        std::swap(jacobian, other);
        damping *= 0.1;
        if (step.norm() < 1e-14) break;
    }
    const double a = fit.value[0];
    if (!(std::abs(a) > 1e-8)) return fail(ErrorCode::input, "the points of the circle lie on one line");
    const double radius = 1 / (2 * std::abs(a));
    const Eigen::Vector2d centre =
        -fit.e() / (2 * a) * Eigen::Vector2d(std::cos(fit.value[2]), std::sin(fit.value[2]));
    CircleThrough result;
    result.centre = size * centre + middle.transpose();
    result.radius = size * radius;
    result.degreesOfFreedom = points.size() - 3;
    if (result.degreesOfFreedom > 0)
        result.scatter = size * std::sqrt(d.squaredNorm() / static_cast<double>(result.degreesOfFreedom));
    const Eigen::Matrix3d inverse = (jacobian.transpose() * jacobian).inverse();
    // d(1 / 2A) = dA / (2 A^2); lengths in units of `size` on both sides.
    result.radiusPerUnit = std::sqrt(std::max(0.0, inverse(0, 0))) / (2 * a * a);
    return result;
}

}  // namespace vestige
