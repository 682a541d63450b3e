#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/simulation/SceneSpec.h"

namespace vestige {

/// Shorthand for writing built-in scenes: each call adds one object or measurement.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::string name) { spec_.name = std::move(name); }

    using Values = std::vector<std::pair<std::string, ParameterValue>>;
    ObjectSpec& add(const std::string& id, const std::string& kind, const Eigen::Vector3d& at,
                    double heading_deg, const Values& values);
    /// A level strip of ground.
    void strip(const std::string& id, const Eigen::Vector3d& at, double length, double width,
               const std::string& material, double roughness = 0);
    /// A dashed line along x from `from` to `to`.
    void dashes(const std::string& id, double from, double to, double y);
    void flight(const Values& values);
    void photogrammetry(const Values& values);
    void measure(const std::string& object, double tape_m, const std::string& from, const std::string& to);
    void handheld(HandheldSpec layer) { spec_.handheld.push_back(std::move(layer)); }

    SceneSpec take() { return std::move(spec_); }

  private:
    SceneSpec spec_;
};

}  // namespace vestige
