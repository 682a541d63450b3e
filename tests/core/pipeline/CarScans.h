#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/scene/Scene.h"

namespace vestige::test {

/// A parked car and what lies round it, seen from above and by handheld scans round it that overlap their
/// neighbours; layers hold their data, the scene's own frame stands at map coordinates.
struct CarScans {
    /// Picked pairs are written into the folder.
    explicit CarScans(const std::filesystem::path& folder, std::uint64_t seed = 100);

    /// What is seen from above, `noise_m` of it; only where x > fromX (car's frame, front positive).
    Layer& addAerial(const std::string& id, double noise_m, double fromX = -100,
                     const Pose& off = Pose::Identity());
    /// The sector of 160 degrees round `azimuth_deg` (0 front, 90 left), millimetres in a frame of its own.
    /// Its first pose is that of five points picked with an error of 2 cm, in the target or in layer `to`.
    Layer& addScan(const std::string& id, double azimuth_deg, const std::string& to = {});

    /// From the layer's file unit, by id.
    const Similarity& truth(const std::string& id) const { return truth_.at(id); }
    /// Distance, at the points of the scan on average, between a pose found and the truth.
    double error(const std::string& id, const Similarity& sceneFromLayer) const;

    static Eigen::Vector3d origin() { return {483400, 4375661, 34}; }
    SceneState scene;

  private:
    std::filesystem::path folder_;
    std::map<std::string, Similarity> truth_;
    std::uint64_t seed_;
};

}  // namespace vestige::test
