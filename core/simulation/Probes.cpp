#include "core/simulation/Probes.h"

#include <algorithm>

namespace vestige {

ProbeCounter::ProbeCounter(const std::vector<Probe>& probes, double radius_m)
    : probeCount_(probes.size()), squaredRadius_(static_cast<float>(radius_m * radius_m)) {
    for (std::uint32_t i = 0; i < probes.size(); ++i) {
        const std::size_t part = probes[i].part;
        byPart_.resize(std::max(byPart_.size(), part + 1));
        byPart_[part].push_back({probes[i].position.cast<float>(), i});
    }
}

void ProbeCounter::count(const Eigen::Vector3f& truth, std::uint16_t part,
                         std::vector<std::uint32_t>& counts) const {
    if (part >= byPart_.size()) return;
    for (const Entry& entry : byPart_[part])
        if ((truth - entry.position).squaredNorm() <= squaredRadius_) ++counts[entry.probe];
}

}  // namespace vestige
