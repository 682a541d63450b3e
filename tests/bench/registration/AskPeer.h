#pragma once

#include "tests/bench/peers/Peer.h"
#include "tests/bench/registration/Pairs.h"

namespace vestige::bench {

using PeerEntry = void (*)(const PeerRequest*, PeerAnswer*);

/// What the peer finds from the pair's first pose.
Pose askPeer(PeerEntry entry, PeerMethod method, const ScanPair& pair, double leaf_m, int threads);

}  // namespace vestige::bench
