#include "core/io/RecordCloud.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <span>

#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/Coordinates.h"
#include "core/io/FieldValues.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 32768;
constexpr std::size_t kBlock = 512;
/// Up to here floats of a file are held as they are, round the origin of its frame.
constexpr double kOwnOrigin = 65536;

using Block = std::array<double, kBlock>;

template <class Number>
void unpack(const std::byte* at, std::size_t step, std::size_t many, Block& values) {
    for (std::size_t i = 0; i < many; ++i, at += step) {
        Number number;
        std::memcpy(&number, at, sizeof number);
        values[i] = static_cast<double>(number);
    }
}

/// The values of points first ... first + many - 1 of a column.
void unpack(const std::byte* body, const RecordColumn& column, std::endian order, std::size_t first,
            std::size_t many, Block& values) {
    const std::byte* at = body + column.offset + first * column.step;
    if (order == std::endian::native) {
        if (column.type == ScalarType::float32) return unpack<float>(at, column.step, many, values);
        if (column.type == ScalarType::float64) return unpack<double>(at, column.step, many, values);
        if (column.type == ScalarType::uint8) return unpack<std::uint8_t>(at, column.step, many, values);
        if (column.type == ScalarType::uint16) return unpack<std::uint16_t>(at, column.step, many, values);
        if (column.type == ScalarType::uint32) return unpack<std::uint32_t>(at, column.step, many, values);
    }
    for (std::size_t i = 0; i < many; ++i, at += column.step) values[i] = readScalar(column.type, at, order);
}

class Records {
  public:
    Records(const std::byte* body, std::size_t points, const RecordLayout& layout, const ReadJob& job)
        : body_(body), points_(points), layout_(layout), job_(job) {}

    std::optional<PointCloud> read() {
        if (points_ == 0) return std::nullopt;
        if (floatsInARow())
            if (auto cloud = readFloats()) return cloud;
        if (!findReach()) return std::nullopt;
        chooseOrigin();
        auto offsets = LargeArray<Eigen::Vector3f>::toFill(points_);
        auto residuals = LargeArray<Eigen::Vector3f>::toFill(far_ ? points_ : 0);
        eachBlock([&](std::size_t, std::size_t first, std::size_t many, std::array<Block, 3>& axes) {
            unpackPlaces(first, many, axes);
            for (std::size_t i = 0; i < many; ++i) {
                const Eigen::Vector3d offset = Eigen::Vector3d(axes[0][i], axes[1][i], axes[2][i]) - origin_;
                offsets[first + i] = offset.cast<float>();
                if (far_) residuals[first + i] = (offset - offsets[first + i].cast<double>()).cast<float>();
            }
        });
        return PointCloud(origin_, std::move(offsets), std::move(residuals), std::move(attributes_));
    }

  private:
    using Places = std::function<void(std::size_t chunk, std::size_t first, std::size_t many,
                                      std::array<Block, 3>& axes)>;

    /// Takes the places of each block, then its attributes.
    void eachBlock(const Places& takePlaces) {
        prepareAttributes();
        std::atomic<std::size_t> done{0};
        parallelChunks(points_, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::array<Block, 3> axes;
            for (std::size_t first = begin; first < end; first += kBlock) {
                const std::size_t many = std::min(kBlock, end - first);
                takePlaces(chunk, first, many, axes);
                setAttributes(first, many, axes);
            }
            job_.report(done += end - begin, points_);
        });
        finishAttributes();
    }

    /// x, y and z one behind the other as floats, and colours whose depth is known.
    bool floatsInARow() const {
        const RecordColumn& x = *column(PointField::x);
        const auto follows = [&](const RecordColumn& one, std::size_t offset) {
            return one.type == ScalarType::float32 && one.step == x.step && one.offset == x.offset + offset;
        };
        return layout_.order == std::endian::native && follows(x, 0) &&
               follows(*column(PointField::y), sizeof(float)) &&
               follows(*column(PointField::z), 2 * sizeof(float)) &&
               (layout_.depth != ColorDepth::guess || !has(PointField::red));
    }

    /// The floats as they are; nothing where one is not usable, or too far from its frame's origin.
    std::optional<PointCloud> readFloats() {
        auto offsets = LargeArray<Eigen::Vector3f>::toFill(points_);
        const RecordColumn& x = *column(PointField::x);
        const std::size_t chunks = (points_ + kGrain - 1) / kGrain;
        std::vector<char> near(chunks, 1);
        eachBlock([&](std::size_t chunk, std::size_t first, std::size_t many, std::array<Block, 3>&) {
            const std::byte* at = body_ + x.offset + first * x.step;
            float* const to = offsets[first].data();
            for (std::size_t i = 0; i < many; ++i, at += x.step)
                std::memcpy(to + 3 * i, at, 3 * sizeof(float));
            float farthest = 0;
            float sum = 0;  // no number once a coordinate is none
            for (std::size_t i = 0; i < 3 * many; ++i) {
                farthest = std::max(farthest, std::abs(to[i]));
                sum += 0 * to[i];
            }
            if (sum != 0 || !(farthest <= static_cast<float>(kOwnOrigin))) near[chunk] = 0;
        });
        if (std::count(near.begin(), near.end(), 0) > 0) {
            attributes_ = {};
            return std::nullopt;
        }
        return PointCloud(Eigen::Vector3d::Zero(), std::move(offsets), LargeArray<Eigen::Vector3f>(),
                          std::move(attributes_));
    }

    /// Colours of three bytes one behind the other come at once, all else column by column.
    void setAttributes(std::size_t first, std::size_t many, std::array<Block, 3>& values) {
        const RecordColumn* red = column(PointField::red);
        const bool bytes = red && bytesInARow();
        if (bytes) {
            const std::byte* at = body_ + red->offset + first * red->step;
            for (std::size_t i = 0; i < many; ++i, at += red->step)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    attributes_.color[first + i][channel] =
                        static_cast<std::uint16_t>(static_cast<std::uint16_t>(at[channel]) * 257);
        }
        for (const RecordColumn& one : layout_.columns) {
            const bool channel = one.field == PointField::red || one.field == PointField::green ||
                                 one.field == PointField::blue;
            if (!bytes || !channel) setAttribute(one, first, many, values[0]);
        }
    }
    bool bytesInARow() const {
        const RecordColumn& red = *column(PointField::red);
        const auto follows = [&](const RecordColumn& one, std::size_t offset) {
            return one.type == ScalarType::uint8 && one.step == red.step && one.offset == red.offset + offset;
        };
        return layout_.depth == ColorDepth::bytes && follows(red, 0) &&
               follows(*column(PointField::green), 1) && follows(*column(PointField::blue), 2);
    }

    const RecordColumn* column(PointField field) const {
        const auto found = std::find_if(layout_.columns.begin(), layout_.columns.end(),
                                        [&](const RecordColumn& one) { return one.field == field; });
        return found == layout_.columns.end() ? nullptr : &*found;
    }
    bool has(PointField field) const { return column(field) != nullptr; }

    void unpackPlaces(std::size_t first, std::size_t many, std::array<Block, 3>& axes) const {
        constexpr std::array kAxes{PointField::x, PointField::y, PointField::z};
        for (std::size_t axis = 0; axis < 3; ++axis)
            unpack(body_, *column(kAxes[axis]), layout_.order, first, many, axes[axis]);
    }

    /// The largest coordinate, and the largest colour where that decides its depth; false where a coordinate
    /// is not usable.
    bool findReach() {
        const std::size_t chunks = (points_ + kGrain - 1) / kGrain;
        std::vector<Eigen::Array3d> least(chunks), most(chunks);
        std::vector<double> brightest(chunks, 0.0);
        std::atomic<bool> usable{true};
        const bool guess = layout_.depth == ColorDepth::guess && has(PointField::red);
        parallelChunks(points_, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::array<Block, 3> axes;
            Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
            Eigen::Array3d high = -low;
            double sum = 0;  // no number once a coordinate is none
            for (std::size_t first = begin; first < end; first += kBlock) {
                const std::size_t many = std::min(kBlock, end - first);
                unpackPlaces(first, many, axes);
                for (int axis = 0; axis < 3; ++axis)
                    for (std::size_t i = 0; i < many; ++i) {
                        const double value = axes[static_cast<std::size_t>(axis)][i];
                        sum += 0 * value;
                        low[axis] = std::min(low[axis], value);
                        high[axis] = std::max(high[axis], value);
                    }
                if (!guess) continue;
                for (const PointField channel : {PointField::red, PointField::green, PointField::blue}) {
                    unpack(body_, *column(channel), layout_.order, first, many, axes[0]);
                    for (std::size_t i = 0; i < many; ++i)
                        brightest[chunk] = std::max(brightest[chunk], axes[0][i]);
                }
            }
            if (sum != 0 || !isUsable(low.matrix()) || !isUsable(high.matrix())) usable = false;
            least[chunk] = low;
            most[chunk] = high;
        });
        if (!usable) return false;
        least_ = least.front();
        most_ = most.front();
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            least_ = least_.min(least[chunk]);
            most_ = most_.max(most[chunk]);
            brightest_ = std::max(brightest_, brightest[chunk]);
        }
        return true;
    }

    /// Floats near their own frame's origin stay what they are, to the bit; else offsets are taken round the
    /// first point, as PointCloudBuilder does.
    void chooseOrigin() {
        const bool floats =
            std::all_of(layout_.columns.begin(), layout_.columns.end(), [](const RecordColumn& one) {
                const bool place =
                    one.field == PointField::x || one.field == PointField::y || one.field == PointField::z;
                return !place || one.type == ScalarType::float32;
            });
        if (floats && least_.abs().max(most_.abs()).maxCoeff() <= kOwnOrigin) return;
        std::array<Block, 3> first;
        unpackPlaces(0, 1, first);
        origin_ = Eigen::Vector3d(first[0][0], first[1][0], first[2][0]).array().round().matrix();
        const Eigen::Array3d farthest = (least_ - origin_.array()).abs().max((most_ - origin_.array()).abs());
        far_ = farthest.maxCoeff() > static_cast<double>(PointCloudBuilder::kExactRange);
    }

    void prepareAttributes() {
        if (has(PointField::red) || has(PointField::packedColor)) attributes_.color.resizeToFill(points_);
        if (has(PointField::normalX)) attributes_.normal.resize(points_);
        if (has(PointField::classification)) attributes_.classification.resize(points_);
        if (has(PointField::gpsTime)) attributes_.gpsTime.resize(points_);
        if (has(PointField::pointSource)) attributes_.pointSource.resize(points_);
        if (has(PointField::returnNumber)) attributes_.returnNumber.resize(points_);
        if (has(PointField::returnCount)) attributes_.returnCount.resize(points_);
        if (const RecordColumn* intensity = column(PointField::intensity)) {
            wordsOnly_ = intensity->type == ScalarType::uint8 || intensity->type == ScalarType::uint16;
            if (wordsOnly_)
                words_.resizeToFill(points_);
            else
                intensities_.resize(points_);
        }
        const double largest = layout_.depth == ColorDepth::bytes   ? 255
                               : layout_.depth == ColorDepth::words ? 65535
                               : brightest_ <= 1                    ? 1
                               : brightest_ <= 255                  ? 255
                                                                    : 65535;
        colorScale_ = 65535 / largest;
    }

    void setAttribute(const RecordColumn& column, std::size_t first, std::size_t many, Block& values) {
        using enum PointField;
        if (column.field == none || column.field == x || column.field == y || column.field == z) return;
        unpack(body_, column, layout_.order, first, many, values);
        const auto each = [&](const auto& set) {
            for (std::size_t i = 0; i < many; ++i) set(first + i, values[i]);
        };
        const auto channel = [&](std::size_t which) {
            each([&](std::size_t i, double value) {
                attributes_.color[i][which] = nearestInteger<std::uint16_t>(colorScale_ * value);
            });
        };
        const auto normal = [&](int axis) {
            // Doubles that are no unit vectors are made so at the end; what a float cannot hold is no
            // direction.
            each([&](std::size_t i, double value) {
                attributes_.normal[i][axis] = std::abs(value) <= std::numeric_limits<float>::max()
                                                  ? static_cast<float>(value)
                                                  : std::numeric_limits<float>::quiet_NaN();
            });
        };
        switch (column.field) {
            case red:
                return channel(0);
            case green:
                return channel(1);
            case blue:
                return channel(2);
            case normalX:
                return normal(0);
            case normalY:
                return normal(1);
            case normalZ:
                return normal(2);
            case packedColor:
                return each([&](std::size_t i, double value) {
                    const auto packed = nearestInteger<std::uint32_t>(value);
                    for (std::size_t which = 0; which < 3; ++which)
                        attributes_.color[i][which] =
                            static_cast<std::uint16_t>((packed >> (16 - 8 * which) & 255) * 257);
                });
            case intensity:
                return each([&](std::size_t i, double value) {
                    if (wordsOnly_)
                        words_[i] = static_cast<std::uint16_t>(value);
                    else
                        intensities_[i] = toFloat(value);
                });
            case classification:
                return each([&](std::size_t i, double value) {
                    attributes_.classification[i] = nearestInteger<std::uint8_t>(value);
                });
            case gpsTime:
                return each([&](std::size_t i, double value) { attributes_.gpsTime[i] = value; });
            case pointSource:
                return each([&](std::size_t i, double value) {
                    attributes_.pointSource[i] = nearestInteger<std::uint16_t>(value);
                });
            case returnNumber:
                return each([&](std::size_t i, double value) {
                    attributes_.returnNumber[i] = nearestInteger<std::uint8_t>(value);
                });
            case returnCount:
                return each([&](std::size_t i, double value) {
                    attributes_.returnCount[i] = nearestInteger<std::uint8_t>(value);
                });
            default:
                return;
        }
    }

    void finishAttributes() {
        parallelFor(attributes_.normal.size(), kGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                attributes_.normal[i] = cleanNormal(attributes_.normal[i].cast<double>());
        });
        if (!has(PointField::intensity)) return;
        attributes_.intensity = wordsOnly_ ? Intensities(std::move(words_)) : Intensities(intensities_);
    }

    const std::byte* body_;
    std::size_t points_;
    const RecordLayout& layout_;
    const ReadJob& job_;
    Eigen::Array3d least_;
    Eigen::Array3d most_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    bool far_ = false;
    double brightest_ = 0;
    double colorScale_ = 1;
    PointAttributes attributes_;
    bool wordsOnly_ = false;
    LargeArray<std::uint16_t> words_;
    std::vector<float> intensities_;
};

}  // namespace

Eigen::Vector3f cleanNormal(const Eigen::Vector3d& normal) {
    const double length = normal.norm();
    if (!std::isfinite(length) || length < 1e-12) return Eigen::Vector3f::Zero();
    // Normals that are unit length to the digits of their file stay bit for bit what they are.
    if (std::abs(length - 1) < 1e-3) return normal.cast<float>();
    return (normal / length).cast<float>();
}

std::optional<PointCloud> readRecords(const std::byte* body, std::size_t points, const RecordLayout& layout,
                                      const ReadJob& job) {
    return Records(body, points, layout, job).read();
}

}  // namespace vestige
