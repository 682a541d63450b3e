#include "core/io/formats/VertexWelder.h"

#include <bit>
#include <random>

namespace vestige {

VertexWelder::Hash::Hash() : seed(std::random_device{}()) {}

std::size_t VertexWelder::Hash::operator()(const Key& key) const {
    std::uint64_t mixed = seed;
    for (const double coordinate : key) {
        mixed ^= std::bit_cast<std::uint64_t>(coordinate);
        mixed *= 0x9e3779b97f4a7c15ULL;
        mixed ^= mixed >> 32;
    }
    return mixed;
}

void VertexWelder::add(const Eigen::Vector3d& corner) {
    // Adding zero makes -0 and 0 one value.
    const Key key{corner.x() + 0.0, corner.y() + 0.0, corner.z() + 0.0};
    const auto [found, isNew] = indices_.try_emplace(key, static_cast<std::uint32_t>(builder_.size()));
    if (isNew) builder_.add(corner);
    triangle_[corners_ % 3] = found->second;
    if (++corners_ % 3 != 0) return;
    if (triangle_[0] == triangle_[1] || triangle_[1] == triangle_[2] || triangle_[2] == triangle_[0])
        ++flat_;
    else
        triangles_.push_back(triangle_);
}

TriangleMesh VertexWelder::build() && {
    if (flat_ > 0) job_.warn(counted(flat_, "triangle") + " with two equal corners left out");
    return {std::move(builder_).build(), std::move(triangles_)};
}

}  // namespace vestige
