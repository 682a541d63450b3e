#include "core/io/ApplyReadOptions.h"

#include <limits>
#include <utility>

#include "core/io/Describe.h"

namespace vestige {
namespace {

constexpr std::uint32_t kDropped = std::numeric_limits<std::uint32_t>::max();

TriangleMesh chosenPart(const TriangleMesh& whole, const ReadOptions& options) {
    const PointCloud& cloud = whole.vertices;
    const std::uint32_t every = whole.isMesh() ? 1 : std::max<std::uint32_t>(1, options.keepEvery);
    std::vector<std::uint32_t> kept;
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        if (options.box && !options.box->contains(cloud.point(i))) continue;
        if (met++ % every == 0) kept.push_back(i);
    }
    TriangleMesh part;
    part.vertices = cloud.select(kept);
    if (!whole.isMesh()) return part;
    std::vector<std::uint32_t> place(cloud.size(), kDropped);
    for (std::uint32_t i = 0; i < kept.size(); ++i) place[kept[i]] = i;
    for (const Triangle& triangle : whole.triangles) {
        const Triangle moved{place[triangle[0]], place[triangle[1]], place[triangle[2]]};
        if (moved[0] != kDropped && moved[1] != kDropped && moved[2] != kDropped)
            part.triangles.push_back(moved);
    }
    return part;
}

}  // namespace

void applyReadOptions(const ReadOptions& options, LoadedGeometry& loaded) {
    if (loaded.heeded) return;
    if (!options.wholeFile()) {
        loaded.geometry = chosenPart(loaded.geometry, options);
        std::vector<std::string> attributes = std::move(loaded.info.attributes);
        loaded.info.attributes.clear();
        loaded.info.bounds = {};
        describeGeometry(loaded.geometry, loaded.info);
        loaded.info.attributes = std::move(attributes);
    }
    if (options.attributes == ReadOptions::Attributes::drawn) loaded.geometry.vertices.keepDrawnAttributes();
}

}  // namespace vestige
