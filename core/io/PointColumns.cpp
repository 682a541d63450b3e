#include "core/io/PointColumns.h"

#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

/// A float offset within its exact range moves a coordinate by less (0.016 mm for metres, with a margin).
constexpr double kRounding = 3e-5;

template <class Values>
void addColumn(std::vector<PointColumn>& columns, const Values& values, const char* name, ScalarType type) {
    if (values.empty()) return;
    columns.push_back({name, type, [&values](std::size_t i) { return static_cast<double>(values[i]); }});
}

}  // namespace

SourceGrid::SourceGrid(const FileInfo* source) {
    if (!source || !source->scale || !(source->scale->array() > 0).all()) return;
    scale_ = source->scale;
    offset_ = source->offset.value_or(Eigen::Vector3d::Zero());
}

Eigen::Vector3d SourceGrid::operator()(const Eigen::Vector3d& point) const {
    if (!scale_) return point;
    const Eigen::Array3d steps = ((point - offset_).array() / scale_->array()).round();
    const Eigen::Vector3d onGrid = (steps * scale_->array()).matrix() + offset_;
    return (onGrid - point).cwiseAbs().maxCoeff() < kRounding ? onGrid : point;
}

bool colorsAreBytes(const PointCloud& cloud) {
    const LargeArray<Color>& colors = cloud.attributes().color;
    return std::all_of(colors.begin(), colors.end(), [](const Color& color) {
        return color[0] % 257 == 0 && color[1] % 257 == 0 && color[2] % 257 == 0;
    });
}

std::vector<PointColumn> pointColumns(const PointCloud& cloud, const SourceGrid& grid) {
    const PointAttributes& attributes = cloud.attributes();
    std::vector<PointColumn> columns;
    constexpr std::array kAxes{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        columns.push_back({kAxes[axis], ScalarType::float64,
                           [&, grid, axis](std::size_t i) { return grid(cloud.point(i))[axis]; }});
    addColumn(columns, attributes.intensity, "intensity", ScalarType::float32);
    if (!attributes.color.empty()) {
        const bool bytes = colorsAreBytes(cloud);
        constexpr std::array kChannels{"red", "green", "blue"};
        for (std::size_t channel = 0; channel < 3; ++channel)
            columns.push_back({kChannels[channel], bytes ? ScalarType::uint8 : ScalarType::uint16,
                               [&attributes, channel, divisor = bytes ? 257 : 1](std::size_t i) {
                                   return static_cast<double>(attributes.color[i][channel] / divisor);
                               }});
    }
    if (!attributes.normal.empty()) {
        constexpr std::array kNormals{"nx", "ny", "nz"};
        for (int axis = 0; axis < 3; ++axis)
            columns.push_back({kNormals[axis], ScalarType::float32, [&attributes, axis](std::size_t i) {
                                   return static_cast<double>(attributes.normal[i][axis]);
                               }});
    }
    addColumn(columns, attributes.classification, "classification", ScalarType::uint8);
    addColumn(columns, attributes.gpsTime, "gps_time", ScalarType::float64);
    addColumn(columns, attributes.pointSource, "point_source_id", ScalarType::uint16);
    addColumn(columns, attributes.returnNumber, "return_number", ScalarType::uint8);
    addColumn(columns, attributes.returnCount, "number_of_returns", ScalarType::uint8);
    return columns;
}

}  // namespace vestige
