#include "tests/ui/shell/SampleScans.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <functional>

#include "core/base/Numbers.h"

namespace vestige::test {
namespace {

using Sink = std::function<void(const Eigen::Vector3d&)>;

/// Points of a parallelogram every `step`, its edges included.
void sheet(const Eigen::Vector3d& from, const Eigen::Vector3d& along, const Eigen::Vector3d& across,
           double step, const Sink& sink) {
    const int n = static_cast<int>(std::round(along.norm() / step));
    const int m = static_cast<int>(std::round(across.norm() / step));
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= m; ++j) sink(from + along * i / n + across * j / m);
}

void yard(double step, const Sink& sink) {
    sheet({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, step, sink);
    sheet({-5, 5, 0}, {10, 0, 0}, {0, 0, 2.5}, step, sink);
    sheet({-5, -5, 0}, {0, 10, 0}, {0, 0, 2.5}, step, sink);
    sheet({-1, -0.5, 0.8}, {2, 0, 0}, {0, 1, 0}, 0.05, sink);
    sheet({-1, -0.5, 0}, {2, 0, 0}, {0, 0, 0.8}, 0.05, sink);
    sheet({-1, -0.5, 0}, {0, 1, 0}, {0, 0, 0.8}, 0.05, sink);
}

void write(const std::filesystem::path& file, double step, const Eigen::Isometry3d& moved) {
    std::ofstream out(file);
    yard(step, [&](const Eigen::Vector3d& point) {
        const Eigen::Vector3d p = moved * point;
        out << fixedText(p.x(), 5) << ' ' << fixedText(p.y(), 5) << ' ' << fixedText(p.z(), 5) << '\n';
    });
}

}  // namespace

SampleScans writeSampleScans(const std::filesystem::path& folder) {
    const SampleScans scans{folder / "yard.xyz", folder / "second scan.xyz"};
    write(scans.target, 0.08, Eigen::Isometry3d::Identity());
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    moved.rotate(Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitZ()));
    moved.translation() = Eigen::Vector3d(kMoved_m, -0.15, 0.05);
    write(scans.source, 0.09, moved);
    return scans;
}

std::filesystem::path writeBall(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "ball.xyz";
    std::ofstream out(file);
    for (int i = 0; i < 4000; ++i) {
        const double z = -1 + 2 * (i + 0.5) / 4000;
        const double angle = 2.399963229728653 * i;
        const double r = std::sqrt(1 - z * z);
        out << fixedText(2 + 0.4 * r * std::cos(angle), 5) << ' ' << fixedText(0.4 * r * std::sin(angle), 5)
            << ' ' << fixedText(2 + 0.4 * z, 5) << '\n';
    }
    return file;
}

}  // namespace vestige::test
