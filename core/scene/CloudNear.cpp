#include "core/scene/CloudNear.h"

namespace vestige {
namespace {

constexpr std::size_t kMost = 100'000;

struct PlanBox {
    Eigen::Vector2d min, max;

    bool contains(const Eigen::Vector3d& point) const {
        return (point.head<2>().array() >= min.array()).all() &&
               (point.head<2>().array() <= max.array()).all();
    }
    bool mayMeet(const Eigen::Vector3d& centre, double radius) const {
        return (centre.head<2>().array() + radius >= min.array()).all() &&
               (centre.head<2>().array() - radius <= max.array()).all();
    }
};

PlanBox boxOf(const std::vector<KindEnd>& ends, double margin_m) {
    PlanBox box{ends.front().position.head<2>(), ends.front().position.head<2>()};
    for (const KindEnd& end : ends) {
        box.min = box.min.cwiseMin(end.position.head<2>());
        box.max = box.max.cwiseMax(end.position.head<2>());
    }
    box.min.array() -= margin_m;
    box.max.array() += margin_m;
    return box;
}

}  // namespace

std::vector<Eigen::Vector3d> cloudNear(const Layer& layer, const std::vector<KindEnd>& ends,
                                       double margin_m) {
    if (!layer.data || !layer.data->octree || ends.empty()) return {};
    const Octree& octree = *layer.data->octree;
    const PointCloud& cloud = octree.cloud();
    if (octree.nodes().empty()) return {};
    const Similarity toScene = sceneFromLayer(layer);
    const PlanBox box = boxOf(ends, margin_m);
    // Leaves that may meet the box first: how many points they have says how many may be passed over.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> leaves;
    std::size_t candidates = 0;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const Octree::Node& node = octree.nodes()[open.back()];
        open.pop_back();
        const Eigen::Vector3d middle = 0.5 * (node.min + node.max).cast<double>();
        const double reach = 0.5 * toScene.scale * (node.max - node.min).cast<double>().norm();
        if (!box.mayMeet(toScene * Eigen::Vector3d(cloud.origin() + middle), reach)) continue;
        if (node.childCount > 0) {
            for (std::uint32_t child = node.childCount; child-- > 0;) open.push_back(node.firstChild + child);
            continue;
        }
        leaves.emplace_back(node.begin, node.end);
        candidates += node.end - node.begin;
    }
    const std::size_t step = candidates / kMost + 1;
    std::vector<Eigen::Vector3d> points;
    std::size_t next = 0, passed = 0;  // of the candidates, in the order of the leaves
    for (const auto& [begin, end] : leaves) {
        for (; next < passed + (end - begin); next += step) {
            const std::uint32_t at = begin + static_cast<std::uint32_t>(next - passed);
            const Eigen::Vector3d point = toScene * cloud.point(octree.order()[at]);
            if (box.contains(point)) points.push_back(point);
        }
        passed += end - begin;
    }
    return points;
}

}  // namespace vestige
