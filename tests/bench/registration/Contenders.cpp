#include "tests/bench/registration/Contenders.h"

#include <stdexcept>

#include "core/base/Parallel.h"
#include "core/registration/FindPose.h"
#include "core/registration/Register.h"
#include "tests/bench/registration/AskPeer.h"

namespace vestige::bench {
namespace {

ParameterSet method(const std::string& name) {
    ParameterSet parameters(registrationParameters());
    if (const Status set = parameters.set("method", name); !set)
        throw std::runtime_error(set.error().sentence());
    return parameters;
}

/// A registration that gives up leaves the first pose, and its error, standing.
Pose poseOf(const Result<RegistrationResult>& result, const ScanPair& pair) {
    return result ? result->targetFromSource.pose : pair.start;
}

Contender ours(const std::string& name, const std::string& methodName) {
    const ParameterSet parameters = method(methodName);
    return {name, true, {1, 2}, {0}, 0, [parameters](const ScanPair& pair, double, int threads) {
                setThreadCount(threads);
                return poseOf(findPose(pair.target, pair.source, {pair.start, 1}, parameters), pair);
            }};
}

Contender oursWithVerdict() {
    const ParameterSet parameters = method("improved-ndt");
    return {"improved NDT with its verdict",
            true,
            {1, 2},
            {0},
            0,
            [parameters](const ScanPair& pair, double, int threads) {
                setThreadCount(threads);
                const TriangleMesh target{pair.target, {}};
                const TriangleMesh source{pair.source, {}};
                return poseOf(attemptRegistration(target, source, {pair.start, 1}, parameters), pair);
            }};
}

Contender peer(const std::string& name, PeerEntry entry, PeerMethod peerMethod, std::vector<int> threads,
               std::vector<double> leaves, double asked) {
    return {name,
            false,
            std::move(threads),
            std::move(leaves),
            asked,
            [entry, peerMethod](const ScanPair& pair, double leaf, int count) {
                return askPeer(entry, peerMethod, pair, leaf, count);
            }};
}

}  // namespace

std::vector<Contender> contenders(bool large) {
    const std::vector<double> cells =
        large ? std::vector<double>{1, 0.4} : std::vector<double>{2, 1, 0.8, 0.6, 0.4};
    const std::vector<double> voxels =
        large ? std::vector<double>{1, 0.4, 0.2} : std::vector<double>{1, 0.8, 0.6, 0.4, 0.2, 0.1};
    std::vector<Contender> all{ours("improved NDT", "improved-ndt"), oursWithVerdict(),
                               ours("our NDT", "ndt"), ours("our ICP", "icp")};
    all.push_back(peer("PCL NDT, Debian", vestige_peer_pcl_debian, PeerMethod::ndt, {1}, cells, 1));
    all.push_back(peer("PCL NDT, AVX2", vestige_peer_pcl_avx2, PeerMethod::ndt, {1}, cells, 1));
    if (!large)
        all.push_back(
            peer("PCL NDT, Debian's library", vestige_peer_pcl_library, PeerMethod::ndt, {1}, {1}, 1));
    all.push_back(peer("PCL NDT, AVX2, source thinned to half a cell", vestige_peer_pcl_avx2,
                       PeerMethod::ndtThin, {1}, cells, 0));
    all.push_back(peer("PCL NDT chain, Debian", vestige_peer_pcl_debian, PeerMethod::ndtChain, {1}, {0}, 0));
    all.push_back(peer("PCL NDT chain, AVX2", vestige_peer_pcl_avx2, PeerMethod::ndtChain, {1}, {0}, 0));
    all.push_back(peer("PCL ICP, AVX2", vestige_peer_pcl_avx2, PeerMethod::icp, {1}, voxels, 0));
    all.push_back(peer("PCL GICP, AVX2", vestige_peer_pcl_avx2, PeerMethod::gicp, {1}, voxels, 0));
#ifdef VESTIGE_BENCH_OPEN3D
    all.push_back(peer("Open3D plane ICP", vestige_peer_open3d, PeerMethod::planeIcp, {1, 2}, voxels, 0));
#endif
    return all;
}

}  // namespace vestige::bench
