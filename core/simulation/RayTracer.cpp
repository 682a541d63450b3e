#include "core/simulation/RayTracer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vestige {
namespace {

using Vector = Eigen::Vector3f;
constexpr std::uint32_t kLeaf = 4;
constexpr int kBins = 16;

struct Box {
    Vector min = Vector::Constant(std::numeric_limits<float>::infinity());
    Vector max = Vector::Constant(-std::numeric_limits<float>::infinity());
    void add(const Box& other) {
        min = min.cwiseMin(other.min);
        max = max.cwiseMax(other.max);
    }
    float area() const {
        const Vector size = max - min;
        return size.minCoeff() < 0 ? 0 : size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    }
};

}  // namespace

struct RayTracer::BuildItem {
    Box box;
    Vector middle;
    std::uint32_t face;
};

namespace {

struct Split {
    int axis = -1;
    float position = 0;
};

/// The cheapest of the bin borders by the surface-area heuristic; no axis when a leaf is cheaper.
template <class Items>
Split cheapestSplit(const Items& items, std::uint32_t begin, std::uint32_t end, const Box& whole) {
    Vector low = Vector::Constant(std::numeric_limits<float>::infinity());
    Vector high = -low;
    for (std::uint32_t i = begin; i < end; ++i) {
        low = low.cwiseMin(items[i].middle);
        high = high.cwiseMax(items[i].middle);
    }
    Split best;
    float bestCost = whole.area() * static_cast<float>(end - begin);
    if (end - begin > 8 * kLeaf) bestCost = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const float size = high[axis] - low[axis];
        if (!(size > 0)) continue;
        std::array<Box, kBins> boxes;
        std::array<std::uint32_t, kBins> counts{};
        for (std::uint32_t i = begin; i < end; ++i) {
            const int bin =
                std::min(kBins - 1, static_cast<int>(kBins * (items[i].middle[axis] - low[axis]) / size));
            boxes[static_cast<std::size_t>(bin)].add(items[i].box);
            ++counts[static_cast<std::size_t>(bin)];
        }
        std::array<float, kBins> rightCost{};
        Box right;
        std::uint32_t rightCount = 0;
        for (std::size_t bin = kBins; bin-- > 1;) {
            right.add(boxes[bin]);
            rightCount += counts[bin];
            rightCost[bin] = right.area() * static_cast<float>(rightCount);
        }
        Box left;
        std::uint32_t leftCount = 0;
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            left.add(boxes[bin - 1]);
            leftCount += counts[bin - 1];
            if (leftCount == 0 || leftCount == end - begin) continue;
            const float cost = left.area() * static_cast<float>(leftCount) + rightCost[bin] + whole.area();
            if (cost >= bestCost) continue;
            bestCost = cost;
            best = {axis, low[axis] + size * static_cast<float>(bin) / kBins};
        }
    }
    return best;
}

}  // namespace

RayTracer::RayTracer(const SurfaceModel& model) {
    std::vector<BuildItem> items;
    items.reserve(model.faces.size());
    normals_.reserve(model.faces.size());
    const auto vertex = [&](std::uint32_t i) -> Vector { return model.vertices[i].cast<float>(); };
    for (std::uint32_t i = 0; i < model.faces.size(); ++i) {
        const auto& [a, b, c] = model.faces[i].corners;
        BuildItem item{{}, {}, i};
        for (const std::uint32_t corner : {a, b, c}) item.box.add({vertex(corner), vertex(corner)});
        item.middle = 0.5F * (item.box.min + item.box.max);
        items.push_back(item);
        normals_.push_back((vertex(b) - vertex(a)).cross(vertex(c) - vertex(a)).normalized());
    }
    nodes_.reserve(2 * items.size() / kLeaf + 1);
    nodes_.emplace_back();
    build(items, 0, 0, static_cast<std::uint32_t>(items.size()));
    corners_.reserve(items.size());
    for (const BuildItem& item : items) {
        const auto& [a, b, c] = model.faces[item.face].corners;
        corners_.push_back({vertex(a), vertex(b) - vertex(a), vertex(c) - vertex(a), item.face});
    }
}

void RayTracer::build(std::vector<BuildItem>& items, std::uint32_t node, std::uint32_t begin,
                      std::uint32_t end) {
    Box whole;
    for (std::uint32_t i = begin; i < end; ++i) whole.add(items[i].box);
    nodes_[node] = {whole.min, begin, whole.max, end - begin};
    if (end - begin <= kLeaf) return;
    const Split split = cheapestSplit(items, begin, end, whole);
    if (split.axis < 0) return;
    const auto middle = std::stable_partition(
        items.begin() + begin, items.begin() + end,
        [&](const BuildItem& item) { return item.middle[split.axis] < split.position; });
    const auto cut = static_cast<std::uint32_t>(middle - items.begin());
    if (cut == begin || cut == end) return;
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = child;
    nodes_[node].count = 0;
    build(items, child, begin, cut);
    build(items, child + 1, cut, end);
}

std::optional<RayHit> RayTracer::cast(const Vector& from, const Vector& direction, float nearest,
                                      float farthest) const {
    if (corners_.empty()) return std::nullopt;
    // A zero would make 0 * infinity where a ray runs within the plane of a box's side.
    const Vector inverse = direction.unaryExpr([](float x) { return 1 / (x == 0 ? 1e-20F : x); });
    const auto enter = [&](const Node& node, float limit) {
        float low = nearest;
        float high = limit;
        for (int axis = 0; axis < 3; ++axis) {
            const float a = (node.min[axis] - from[axis]) * inverse[axis];
            const float b = (node.max[axis] - from[axis]) * inverse[axis];
            low = std::max(low, a < b ? a : b);
            high = std::min(high, a < b ? b : a);
        }
        return low <= high ? low : std::numeric_limits<float>::infinity();
    };
    RayHit best{farthest, 0};
    bool found = false;
    std::array<std::pair<std::uint32_t, float>, 96> stack;
    std::size_t depth = 0;
    if (const float at = enter(nodes_[0], farthest); at <= farthest) stack[depth++] = {0, at};
    while (depth > 0) {
        const auto [index, reached] = stack[--depth];
        if (reached > best.distance) continue;
        const Node& node = nodes_[index];
        if (node.count == 0) {
            const float first = enter(nodes_[node.first], best.distance);
            const float second = enter(nodes_[node.first + 1], best.distance);
            const bool swapped = second < first;
            const float far = swapped ? first : second;
            const float near = swapped ? second : first;
            if (far <= best.distance && depth < stack.size())
                stack[depth++] = {node.first + (swapped ? 0U : 1U), far};
            if (near <= best.distance && depth < stack.size())
                stack[depth++] = {node.first + (swapped ? 1U : 0U), near};
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Corner& face = corners_[i];
            const Vector p = direction.cross(face.ac);
            const float determinant = face.ab.dot(p);
            if (std::abs(determinant) < 1e-12F) continue;
            const float scale = 1 / determinant;
            const Vector s = from - face.a;
            const float u = s.dot(p) * scale;
            if (u < 0 || u > 1) continue;
            const Vector q = s.cross(face.ab);
            const float v = direction.dot(q) * scale;
            if (v < 0 || u + v > 1) continue;
            const float distance = face.ac.dot(q) * scale;
            if (distance < nearest || distance > best.distance) continue;
            if (distance == best.distance && found && face.face > best.face) continue;
            best = {distance, face.face};
            found = true;
        }
    }
    if (!found) return std::nullopt;
    return best;
}

bool RayTracer::sees(const Vector& from, const Vector& to, float margin) const {
    const float length = (to - from).norm();
    if (length <= 2 * margin) return true;
    return !cast(from, (to - from) / length, margin, length - margin);
}

}  // namespace vestige
