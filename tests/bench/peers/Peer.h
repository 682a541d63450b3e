#pragma once

#include <cstddef>

namespace vestige::bench {

/// Points as the caller has them: x, y, z in single precision, metres. What a peer makes of them is part of
/// its time.
struct PeerCloud {
    const float* xyz;
    std::size_t count;
};

enum class PeerMethod {
    ndt,       ///< one cell size, the source thinned to 0.1 m
    ndtThin,   ///< one cell size, the source thinned to half of it
    ndtChain,  ///< cells of 1.0 m to 0.328 m, each 0.8 of the one before, each from the pose before
    icp,       ///< point to point
    gicp,
    planeIcp,  ///< point to plane
    reference  ///< GICP from 1.0 m down to 0.03 m: no contender, the pose of pairs that have no truth
};

struct PeerRequest {
    PeerMethod method;
    PeerCloud target;
    PeerCloud source;
    double start[16];  ///< target from source, by columns
    double leaf_m;     ///< NDT: edge of a cell; the others: voxel filter of both clouds
    int threads;
};

struct PeerAnswer {
    double targetFromSource[16];  ///< by columns
    int iterations;
};

}  // namespace vestige::bench

// Each peer is a shared library that shows only this function: its own compiler flags, no template shared
// with ours or with another peer.
extern "C" {
void vestige_peer_pcl_debian(const vestige::bench::PeerRequest* request, vestige::bench::PeerAnswer* answer);
void vestige_peer_pcl_library(const vestige::bench::PeerRequest* request, vestige::bench::PeerAnswer* answer);
void vestige_peer_pcl_avx2(const vestige::bench::PeerRequest* request, vestige::bench::PeerAnswer* answer);
void vestige_peer_open3d(const vestige::bench::PeerRequest* request, vestige::bench::PeerAnswer* answer);
}
