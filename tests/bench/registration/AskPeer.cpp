#include "tests/bench/registration/AskPeer.h"

namespace vestige::bench {

Pose askPeer(PeerEntry entry, PeerMethod method, const ScanPair& pair, double leaf_m, int threads) {
    const auto& target = pair.target.offsets();
    const auto& source = pair.source.offsets();
    PeerRequest request{
        method, {target.front().data(), target.size()}, {source.front().data(), source.size()}, {}, leaf_m,
        threads};
    Eigen::Map<Eigen::Matrix4d>(request.start) = pair.start.matrix();
    PeerAnswer answer{};
    entry(&request, &answer);
    Pose found = Pose::Identity();
    found.matrix() = Eigen::Map<const Eigen::Matrix4d>(answer.targetFromSource);
    found.linear() = nearestRotation(found.linear());
    return found;
}

}  // namespace vestige::bench
