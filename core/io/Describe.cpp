#include "core/io/Describe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/io/AttributeNames.h"

namespace vestige {

void describeGeometry(const TriangleMesh& geometry, FileInfo& info) {
    info.points = geometry.vertices.size();
    info.triangles = geometry.triangles.size();
    info.bounds = geometry.vertices.bounds();
    const PointAttributes& attributes = geometry.vertices.attributes();
    info.attributes = attributeNames({.intensity = !attributes.intensity.empty(),
                                      .color = !attributes.color.empty(),
                                      .classification = !attributes.classification.empty(),
                                      .gpsTime = !attributes.gpsTime.empty(),
                                      .normals = !attributes.normal.empty(),
                                      .pointSource = !attributes.pointSource.empty(),
                                      .returnNumber = !attributes.returnNumber.empty(),
                                      .returnCount = !attributes.returnCount.empty()});
    info.timeSpan.reset();
    for (const double time : attributes.gpsTime) {
        if (!std::isfinite(time)) continue;
        if (!info.timeSpan) info.timeSpan.emplace(time, time);
        info.timeSpan->first = std::min(info.timeSpan->first, time);
        info.timeSpan->second = std::max(info.timeSpan->second, time);
    }
}

LoadedGeometry loaded(TriangleMesh geometry, std::string format, std::string version, ReadJob& job) {
    LoadedGeometry result;
    result.info.path = job.path();
    result.info.format = std::move(format);
    result.info.version = std::move(version);
    describeGeometry(geometry, result.info);
    if (geometry.vertices.empty()) job.warn("the file has no points");
    result.info.warnings = std::move(job.warnings());
    result.info.damage = job.damage();
    result.info.companions = job.companions();
    result.info.companionStamps = job.companionStamps();
    result.geometry = std::move(geometry);
    return result;
}

}  // namespace vestige
