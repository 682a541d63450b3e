#include "core/io/formats/PntsPoints.h"

#include <Eigen/LU>
#include <cmath>
#include <functional>

#include "core/base/Numbers.h"
#include "core/io/Bytes.h"
#include "core/io/PointSink.h"

namespace vestige {
namespace {

std::uint16_t channel(unsigned value, unsigned largest) {
    return static_cast<std::uint16_t>((255 * value + largest / 2) / largest * 257);
}

std::function<Color(std::size_t)> colorsOf(const PntsTables& tables) {
    for (const char* name : {"RGBA", "RGB"})
        if (const PntsArray* array = tables.feature(name))
            return [array](std::size_t i) -> Color {
                const std::byte* at = array->data + i * array->stride();
                return {channel(std::to_integer<unsigned>(at[0]), 255),
                        channel(std::to_integer<unsigned>(at[1]), 255),
                        channel(std::to_integer<unsigned>(at[2]), 255)};
            };
    if (const PntsArray* array = tables.feature("RGB565"))
        return [array](std::size_t i) -> Color {
            const unsigned packed = load<std::uint16_t>(array->data + 2 * i);
            return {channel(packed >> 11, 31), channel(packed >> 5 & 63, 63), channel(packed & 31, 31)};
        };
    if (tables.constantColor) {
        const auto& constant = *tables.constantColor;
        const Color color{channel(constant[0], 255), channel(constant[1], 255), channel(constant[2], 255)};
        return [color](std::size_t) { return color; };
    }
    return {};
}

std::function<Eigen::Vector3d(std::size_t)> normalsOf(const PntsTables& tables) {
    if (const PntsArray* array = tables.feature("NORMAL"))
        return [array](std::size_t i) {
            return Eigen::Vector3d(array->value(i, 0), array->value(i, 1), array->value(i, 2));
        };
    if (const PntsArray* array = tables.feature("NORMAL_OCT16P"))
        return [array](std::size_t i) {
            const std::byte* at = array->data + i * array->stride();
            return Eigen::Vector3d(
                octNormal(std::to_integer<std::uint8_t>(at[0]), std::to_integer<std::uint8_t>(at[1]))
                    .cast<double>());
        };
    return {};
}

/// Of point i in the tile's frame.
class Positions {
  public:
    explicit Positions(const PntsTables& tables)
        : tables_(tables),
          whole_(tables.feature("POSITION")),
          quantised_(tables.feature("POSITION_QUANTIZED")) {}

    Eigen::Vector3d operator()(std::size_t i) const {
        const PntsArray& array = whole_ ? *whole_ : *quantised_;
        Eigen::Vector3d point(array.value(i, 0), array.value(i, 1), array.value(i, 2));
        if (!whole_) point = tables_.volumeOffset + point.cwiseProduct(tables_.volumeScale) / 65535.0;
        return tables_.rtcCenter + point;
    }

  private:
    const PntsTables& tables_;
    const PntsArray* whole_;
    const PntsArray* quantised_;
};

}  // namespace

Eigen::Vector3f octNormal(std::uint8_t x, std::uint8_t y) {
    Eigen::Vector3d v(x / 255.0 * 2 - 1, y / 255.0 * 2 - 1, 0);
    v.z() = 1 - std::abs(v.x()) - std::abs(v.y());
    if (v.z() < 0) {
        const double unfolded = v.x();
        v.x() = std::copysign(1 - std::abs(v.y()), unfolded);
        v.y() = std::copysign(1 - std::abs(unfolded), v.y());
    }
    return v.normalized().cast<float>();
}

void addPntsPoints(const PntsTables& tables, const Eigen::Matrix4d& rootFromTile, TileCloud& cloud,
                   ReadJob& job) {
    const auto color = colorsOf(tables);
    const auto normal = normalsOf(tables);
    cloud.beginTile(tables.attributes(), tables.points);
    if (tables.points == 0) return;

    const bool moved = !rootFromTile.isIdentity(0);
    const Eigen::Matrix3d linear = rootFromTile.topLeftCorner<3, 3>();
    const Eigen::Vector3d translation = rootFromTile.topRightCorner<3, 1>();
    const Eigen::Matrix3d forNormals = linear.inverse().transpose();
    const Positions position(tables);
    const PntsArray* batch = tables.feature("BATCH_ID");
    for (std::size_t i = 0; i < tables.points; ++i) {
        job.step(i, tables.points);
        Eigen::Vector3d point = position(i);
        if (moved) point = linear * point + translation;
        if (!point.allFinite())
            job.refuse("point " + std::to_string(i + 1) + " has a coordinate that is no finite number",
                       "finite coordinates");
        std::size_t row = i;
        if (batch && !tables.properties.empty()) {
            const double number = batch->value(i);
            if (!(number >= 0 && number < static_cast<double>(tables.batches)))
                job.refuse("point " + std::to_string(i + 1) + " is of batch " + exactText(number),
                           "numbers below " + std::to_string(tables.batches));
            row = static_cast<std::size_t>(number);
        }
        if (!cloud.add(point)) continue;
        if (color) cloud.addColor(color(i));
        if (normal)
            cloud.addNormal(
                cleanNormal(moved ? Eigen::Vector3d((forNormals * normal(i)).normalized()) : normal(i)));
        for (const PntsArray& property : tables.properties)
            if (cloud.wants(property.field)) cloud.addValue(property.field, property.value(row));
    }
}

}  // namespace vestige
