#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/importer/ImportedScene.h"

namespace vestige::importer {

/// A component or a build item: an object, of this part or of another one, at a place.
struct ThreeMfPlace {
    std::string part;  ///< without the leading '/'; empty: the same part
    std::uint32_t object = 0;
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
};

struct ThreeMfObject {
    ImportedMesh mesh;
    std::vector<ThreeMfPlace> components;
};

/// One model part of a 3MF archive: its objects, its build, and what of it is passed over.
struct ThreeMfPart {
    double metresPerUnit = 0.001;
    std::map<std::uint32_t, ThreeMfObject> objects;
    std::vector<ThreeMfPlace> build;
    std::set<std::string> passedOver;  ///< "textures", "beam lattices", ...
};

/// Reads a part's XML (changed by that) in double, by 3MF Core 1.3 chapters 3 and 4, with the colours of
/// base materials and of colour groups (Materials 1.2) where each vertex has one. Throws ErrorException that
/// names `part`.
ThreeMfPart parseThreeMfPart(std::vector<std::byte>& xml, const std::string& part);

}  // namespace vestige::importer
