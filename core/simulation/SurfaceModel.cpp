#include "core/simulation/SurfaceModel.h"

#include <algorithm>

namespace vestige {

const FeaturePoint* SurfaceModel::feature(std::string_view name) const {
    const auto found = std::find_if(features.begin(), features.end(),
                                    [&](const FeaturePoint& feature) { return feature.name == name; });
    return found == features.end() ? nullptr : &*found;
}

void SurfaceModel::append(const SurfaceModel& other, const Pose& hereFromOther, const std::string& prefix) {
    const auto firstVertex = static_cast<std::uint32_t>(vertices.size());
    const auto firstPart = static_cast<std::uint16_t>(parts.size());
    const std::string before = prefix.empty() ? std::string() : prefix + ".";
    for (const Eigen::Vector3d& vertex : other.vertices) vertices.push_back(hereFromOther * vertex);
    for (const std::string& part : other.parts) parts.push_back(before + part);
    for (Face face : other.faces) {
        for (std::uint32_t& corner : face.corners) corner += firstVertex;
        face.part = static_cast<std::uint16_t>(face.part + firstPart);
        faces.push_back(face);
    }
    for (FeaturePoint feature : other.features) {
        feature.name = before + feature.name;
        feature.position = hereFromOther * feature.position;
        feature.lookFrom = hereFromOther.linear() * feature.lookFrom;
        feature.part = static_cast<std::uint16_t>(feature.part + firstPart);
        features.push_back(std::move(feature));
    }
    for (const Eigen::Vector3d& light : other.lights) lights.push_back(hereFromOther * light);
}

BoundingBox SurfaceModel::boundsOf(const std::vector<std::string>& names) const {
    BoundingBox box;
    for (const Face& face : faces) {
        if (!names.empty() && std::find(names.begin(), names.end(), parts[face.part]) == names.end())
            continue;
        for (const std::uint32_t corner : face.corners) box.add(vertices[corner]);
    }
    return box;
}

}  // namespace vestige
