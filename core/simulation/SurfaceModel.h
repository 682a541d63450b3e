#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/geometry/TriangleMesh.h"
#include "core/simulation/Material.h"

namespace vestige {

/// A point of an object that can be aimed at: where it truly is, and from where one sees it.
struct FeaturePoint {
    std::string name;
    Eigen::Vector3d position;
    std::uint16_t part = 0;    ///< the part it lies on
    Eigen::Vector3d lookFrom;  ///< unit vector from the feature to a good viewpoint
    std::string snap{};        ///< what an analyst would fit there ("edge"); empty: nothing
};

/// One face of a model: its corners, what it is made of, and which part of the object it belongs to.
struct Face {
    Triangle corners;
    Material material;
    std::uint16_t part;
};

/// Surfaces of one object, or of the whole scene; metres. Parts are named pieces ("roof", "right mirror").
struct SurfaceModel {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Face> faces;
    std::vector<std::string> parts;
    std::vector<FeaturePoint> features;
    std::vector<Eigen::Vector3d> lights;  ///< street lamps that light the photographs

    const FeaturePoint* feature(std::string_view name) const;
    /// Adds `other` moved by `hereFromOther`, its parts and features named "PREFIX.name" (unless the prefix
    /// is empty).
    void append(const SurfaceModel& other, const Pose& hereFromOther, const std::string& prefix);
    /// Bounds of the faces whose part is one of `parts`; of all faces when it is empty.
    BoundingBox boundsOf(const std::vector<std::string>& parts) const;
};

}  // namespace vestige
