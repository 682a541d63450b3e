#include "core/io/IntoMetres.h"

#include <utility>

namespace vestige {
namespace {

/// Of a device that stands in the file's frame and measures in the file's unit.
Pose moved(const Pose& fileFromDevice, const Similarity& metresFromFile) {
    Pose pose = metresFromFile.pose * fileFromDevice;
    pose.translation() = metresFromFile * Eigen::Vector3d(fileFromDevice.translation());
    return pose;
}

}  // namespace

void moveIntoMetres(FileInfo& info, const Similarity& metresFromFile) {
    for (ScanInfo& scan : info.scans) scan.fileFromScan = moved(scan.fileFromScan, metresFromFile);
    for (ImageInfo& image : info.images)
        if (image.fileFromImage) image.fileFromImage = moved(*image.fileFromImage, metresFromFile);
    if (!info.bounds.empty()) info.bounds = info.bounds.transformed(metresFromFile);
    const double scale = metresFromFile.scale;
    if (info.scale) *info.scale *= scale;
    // A grid only stays where it was when nothing but the unit changes.
    if (metresFromFile.pose.matrix() == Eigen::Matrix4d::Identity()) {
        if (info.offset) *info.offset *= scale;
    } else if (scale != 1) {
        info.offset.reset();
    }
    info.metresPerUnit = 1;
    info.crs.clear();
    info.crsRecords.clear();
}

void moveIntoMetres(LoadedGeometry& loaded, const Similarity& metresFromFile) {
    loaded.geometry = std::move(loaded.geometry).transformed(metresFromFile);
    moveIntoMetres(loaded.info, metresFromFile);
}

}  // namespace vestige
