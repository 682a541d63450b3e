#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/FileStamp.h"
#include "core/base/Units.h"
#include "core/geometry/BoundingBox.h"
#include "core/geometry/Octree.h"
#include "core/geometry/TriangleMesh.h"
#include "core/io/FileInfo.h"
#include "core/registration/RegistrationResult.h"
#include "core/scene/FileEvidence.h"

namespace vestige {

struct Cleaning;

enum class LayerRole { aerial, handheld, photogrammetry };
std::string_view name(LayerRole role);
std::optional<LayerRole> layerRoleFromName(std::string_view name);
/// The method whose column a layer's picks count for where the case names none: "lidar" or "photogrammetry".
std::string_view defaultMethod(LayerRole role);
/// Colour by source of the layer at that place in the case, from a palette that colour-blind eyes can tell
/// apart.
std::array<std::uint8_t, 3> defaultTint(std::size_t place);

/// Heavy data of a layer: read once, never changed, shared by scene, view, jobs and undo.
struct LayerData {
    std::shared_ptr<const TriangleMesh> geometry;  ///< as read, file unit
    std::shared_ptr<const PointCloud> points;      ///< aliases geometry->vertices
    std::shared_ptr<const Octree> octree;          ///< over `points`
    FileInfo info;
    std::string sha256;                        ///< of the file, and of what belongs to it: InputHash
    std::vector<std::string> companionSha256;  ///< of info.companions, in their order
    FileStamp stamp;                           ///< of the file when it was read
    /// Of a cleaned layer: what it was cleaned from, and which points of that are left (ascending). Null
    /// where nothing was taken away.
    std::shared_ptr<const LayerData> uncleaned;
    std::shared_ptr<const std::vector<std::uint32_t>> kept;
    /// Of a first look at a large file: how many points are still being read. `points` are some of them,
    /// spread over the file and exact; there is no sha256 yet. 0: these are all.
    std::uint64_t awaitedPoints = 0;

    bool isPreview() const { return awaitedPoints > 0; }
};

/// Where a layer's registration starts.
struct InitIdentity {};
struct InitPicks {
    std::filesystem::path picks;  ///< absolute once read from a case
    std::string to{};             ///< the layer that the pose leads to; empty: the case's target
};
struct InitPose {
    Similarity targetFromSource;
    std::string to{};  ///< as above
};
struct InitAuto {};
using InitialPoseSpec = std::variant<InitIdentity, InitPicks, InitPose, InitAuto>;
/// The layer that a first pose leads to; empty: the case's target.
std::string referenceOf(const InitialPoseSpec& init);

/// One cloud or mesh of a case.
struct Layer {
    std::string id;    ///< unique in the case
    std::string name;  ///< for people; the id where the case gives none
    LayerRole role = LayerRole::aerial;
    std::string method;                    ///< the column its picks count for: "lidar", "photogrammetry"
    std::filesystem::path path;            ///< absolute once read from a case
    std::optional<FileEvidence> evidence;  ///< what the file is to be; nothing: not noted yet
    std::optional<LengthUnit> unit;        ///< nothing: recognised
    std::uint32_t keepEvery = 1;           ///< of the file's points every k-th is loaded, the first included
    std::optional<BoundingBox> box;  ///< only what lies in it is loaded; in the file's own unit and frame
    InitialPoseSpec init;
    bool salvage = false;  ///< of a damaged file what is whole is read; someone has agreed to that
    bool visible = true;
    std::array<std::uint8_t, 3> tint{160, 180, 200};  ///< colour by source
    /// What cleaning took out of the scene; null for nothing. The file keeps it.
    std::shared_ptr<const Cleaning> cleaning;

    std::shared_ptr<const LayerData> data;           ///< null until loaded
    std::optional<RegistrationResult> registration;  ///< null until registered

    /// Whether only a part of the file is loaded, because the case says so.
    bool isThinned() const { return keepEvery > 1 || box.has_value(); }
    /// Metres in the layer's own frame from file units: the unit given, else what the file says, else metres.
    double metresPerUnit() const;
    /// That as a unit, for people; the nearest one of a file that names another.
    LengthUnit lengthUnit() const;
    /// What the file says, where its unit is one of ours.
    std::optional<LengthUnit> fileUnit() const;
};

/// Where the layer lies in the scene: its registration if it has one, else just its unit.
Similarity sceneFromLayer(const Layer& layer);

}  // namespace vestige
