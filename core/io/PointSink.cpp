#include "core/io/PointSink.h"

#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/io/Coordinates.h"
#include "core/io/FieldValues.h"

namespace vestige {

PointSink::PointSink(const std::vector<PointField>& fields, ColorDepth depth)
    : fields_(fields), depth_(depth) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        switch (fields[i]) {
            case PointField::none:
                break;
            case PointField::x:
                x_ = i;
                break;
            case PointField::y:
                y_ = i;
                break;
            case PointField::z:
                z_ = i;
                break;
            case PointField::red:
                red_ = i;
                break;
            case PointField::green:
                green_ = i;
                break;
            case PointField::blue:
                blue_ = i;
                break;
            case PointField::normalX:
                normalX_ = i;
                break;
            case PointField::normalY:
                normalY_ = i;
                break;
            case PointField::normalZ:
                normalZ_ = i;
                break;
            default:
                columns_.emplace_back(fields[i], i);
        }
    }
}

bool PointSink::add(const double* row) {
    const Eigen::Vector3d point(row[x_], row[y_], row[z_]);
    if (!isUsable(point)) return false;
    builder_.add(point);
    if (red_ && green_ && blue_) addColor(row[*red_], row[*green_], row[*blue_]);
    if (normalX_ && normalY_ && normalZ_)
        builder_.attributes().normal.push_back(cleanNormal({row[*normalX_], row[*normalY_], row[*normalZ_]}));
    PointAttributes& attributes = builder_.attributes();
    for (const auto& [field, column] : columns_) {
        const double value = row[column];
        if (field == PointField::packedColor) {
            const auto packed = nearestInteger<std::uint32_t>(value);
            attributes.color.push_back({static_cast<std::uint16_t>((packed >> 16 & 255) * 257),
                                        static_cast<std::uint16_t>((packed >> 8 & 255) * 257),
                                        static_cast<std::uint16_t>((packed & 255) * 257)});
        } else {
            appendValue(attributes, field, value);
        }
    }
    return true;
}

bool PointSink::addRecords(const std::byte* body, std::size_t points, RecordLayout layout,
                           const ReadJob& job) {
    for (std::size_t i = 0; i < fields_.size(); ++i) layout.columns[i].field = fields_[i];
    layout.depth = depth_;
    atOnce_ = readRecords(body, points, layout, job);
    return atOnce_.has_value();
}

void PointSink::addColor(double red, double green, double blue) {
    if (depth_ == ColorDepth::guess) {
        undecidedColors_.emplace_back(toFloat(red), toFloat(green), toFloat(blue));
        return;
    }
    const auto channel = [&](double value) {
        return depth_ == ColorDepth::bytes
                   ? static_cast<std::uint16_t>(nearestInteger<std::uint8_t>(value) * 257)
                   : nearestInteger<std::uint16_t>(value);
    };
    builder_.attributes().color.push_back({channel(red), channel(green), channel(blue)});
}

void PointSink::finishColors() {
    if (undecidedColors_.empty()) return;
    float largest = 0;
    for (const Eigen::Vector3f& color : undecidedColors_) largest = std::max(largest, color.maxCoeff());
    const double scale = largest <= 1 ? 65535.0 : largest <= 255 ? 257.0 : 1.0;
    LargeArray<Color>& colors = builder_.attributes().color;
    colors.reserve(undecidedColors_.size());
    for (const Eigen::Vector3f& color : undecidedColors_) {
        Color& stored = colors.emplace_back();
        for (int i = 0; i < 3; ++i) stored[i] = nearestInteger<std::uint16_t>(scale * color[i]);
    }
}

PointCloud PointSink::build() && {
    if (atOnce_) return std::move(*atOnce_);
    finishColors();
    return std::move(builder_).build();
}

}  // namespace vestige
