#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace vestige {

/// A place on a part of the scene whose echoes are counted, to know whether a scan really shows it.
struct Probe {
    Eigen::Vector3d position;  ///< site frame
    std::uint16_t part = 0;
};

/// Counts, per probe, the echoes that truly came from the probe's own part within `radius_m` of it. Where an
/// echo truly came from is known to the simulator alone, before noise. Not for several threads at once;
/// counts of chunks are added.
class ProbeCounter {
  public:
    ProbeCounter(const std::vector<Probe>& probes, double radius_m);

    std::vector<std::uint32_t> zeroes() const { return std::vector<std::uint32_t>(probeCount_, 0); }
    void count(const Eigen::Vector3f& truth, std::uint16_t part, std::vector<std::uint32_t>& counts) const;

  private:
    struct Entry {
        Eigen::Vector3f position;
        std::uint32_t probe;
    };
    std::vector<std::vector<Entry>> byPart_;
    std::size_t probeCount_;
    float squaredRadius_;
};

}  // namespace vestige
