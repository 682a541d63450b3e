#include "core/io/formats/PcdBody.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/io/Bytes.h"
#include "core/io/Coordinates.h"
#include "core/io/PointSink.h"
#include "core/io/TextScanner.h"
#include "core/io/formats/Lzf.h"

namespace vestige {
namespace {

class BodyReader {
  public:
    BodyReader(std::string_view file, const PcdHeader& header, ReadJob& job)
        : file_(file), header_(header), job_(job), row_(header.columns) {
        std::vector<std::string> names;
        auto depth = ColorDepth::guess;
        for (const PcdField& field : header.fields) {
            names.push_back(field.count == 1 ? field.name
                                             : field.name + "[" + std::to_string(field.count) + "]");
            const PointField meaning = fieldOfName(field.name);
            if (meaning == PointField::red && sizeOf(field.type) == 1) depth = ColorDepth::bytes;
            if (meaning == PointField::red && field.type == ScalarType::uint16) depth = ColorDepth::words;
        }
        const std::vector<PointField> meanings = fieldsOfNames(names, header.fieldsLine, job);
        std::vector<PointField> columns(header.columns, PointField::none);
        coordinate_.resize(header.fields.size());
        for (std::size_t i = 0; i < header.fields.size(); ++i) {
            if (header.fields[i].count != 1) continue;
            columns[header.fields[i].column] = meanings[i];
            coordinate_[i] =
                meanings[i] == PointField::x || meanings[i] == PointField::y || meanings[i] == PointField::z;
            if (meanings[i] == PointField::packedColor) packedField_ = i;
        }
        sink_.emplace(columns, depth);
    }

    PointCloud read() {
        const auto readAll = [&] {
            switch (header_.encoding) {
                case PcdEncoding::ascii:
                    return readAscii();
                case PcdEncoding::binary:
                    return readBinary();
                case PcdEncoding::compressed:
                    return readCompressed();
            }
        };
        job_.untilDamage(readAll, [&] {
            return WholePart{sink_->size(), firstOf(sink_->size() + holes_, header_.points, "point")};
        });
        if (holes_ > 0) job_.warn(counted(holes_, "point") + " without finite coordinates left out");
        if (header_.movedViewpoint) job_.warn("VIEWPOINT is not applied to the points");
        return std::move(*sink_).build();
    }

  private:
    /// PCL writes not-a-number where a grid of points has a hole; what is a number must be a place.
    template <class Refuse>
    void addRow(const Refuse& refuse) {
        if (sink_->add(row_.data())) return;
        for (std::size_t i = 0; i < header_.fields.size(); ++i)
            if (coordinate_[i] && std::isfinite(row_[header_.fields[i].column]) &&
                std::abs(row_[header_.fields[i].column]) > kLargestCoordinate)
                refuse("point " + std::to_string(sink_->size() + holes_ + 1) + ": " +
                           std::string(kUnusableCoordinate),
                       std::string(kUsableCoordinates));
        ++holes_;
    }

    /// How many of the points the file can hold.
    std::size_t possible(std::size_t smallest, std::size_t available) {
        return std::min(header_.points, available / smallest);
    }

    [[noreturn]] void refuseTooShort(std::size_t smallest, std::size_t available) const {
        job_.refuseByte(
            header_.bodyOffset,
            "the header promises " + std::to_string(header_.points) +
                " points, but the file ends too early for them",
            std::to_string(smallest) + " bytes or more for each, " + std::to_string(available) + " are left");
    }

    /// A packed colour written as text: the integer itself, or a float whose bits are the integer.
    static double packedFromText(double value) {
        if (std::isnan(value)) return 0;
        if (std::abs(value) >= 1) return value < 0 || value > 4294967295.0 ? 0 : std::floor(value);
        return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    }

    void readAscii() {
        TextScanner scanner(file_, header_.bodyOffset, header_.bodyLine);
        const std::size_t smallest = 2 * header_.columns;
        const std::size_t available = file_.size() - scanner.offset() + 1;
        const std::size_t most = possible(smallest, available);
        sink_->reserve(most);
        std::size_t done = 0;
        while (done < header_.points) {
            const std::size_t line = scanner.line();
            if (scanner.atEnd() && most < header_.points) refuseTooShort(smallest, available);
            if (scanner.atEnd())
                job_.refuseLine(line, "the file ends after " + counted(done, "point"),
                                std::to_string(header_.points) + " points as the header says");
            const std::string_view text = scanner.nextLine();
            if (trimmed(text).empty()) continue;
            job_.step(done++, header_.points);
            readRow(text, line);
            addRow([&](const std::string& what, const std::string& expected) {
                job_.refuseLine(line, what, expected);
            });
        }
    }

    void readRow(std::string_view text, std::size_t line) {
        const char* at = text.data();
        const char* end = at + text.size();
        for (double& value : row_) {
            while (at != end && (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r')) ++at;
            const auto number = takeNumber(at, end);
            if (!number)
                job_.refuseLine(line, "a value is missing or no number",
                                std::to_string(row_.size()) + " numbers on each line");
            value = *number;
        }
        if (packedField_) {
            double& packed = row_[header_.fields[*packedField_].column];
            packed = packedFromText(packed);
        }
    }

    /// Field by field; `at(field)` is where the point's values of that field begin.
    template <class At>
    void readPoint(const At& at) {
        for (std::size_t i = 0; i < header_.fields.size(); ++i) {
            const PcdField& field = header_.fields[i];
            if (field.count != 1) continue;
            if (i == packedField_ && sizeOf(field.type) == 4)
                row_[field.column] = load<std::uint32_t>(at(field));
            else
                row_[field.column] = readScalar(field.type, at(field));
        }
        addRow([&](const std::string& what, const std::string& expected) {
            // The bytes of a point of a compressed file stand nowhere together.
            if (header_.encoding == PcdEncoding::compressed) job_.refuse(what, expected);
            job_.refuseByte(header_.bodyOffset + (sink_->size() + holes_) * header_.stride, what, expected);
        });
    }

    void readBinary() {
        const std::size_t available = file_.size() - header_.bodyOffset;
        const std::size_t points = possible(header_.stride, available);
        const std::byte* body = reinterpret_cast<const std::byte*>(file_.data()) + header_.bodyOffset;
        if (points == header_.points &&
            readAtOnce(body, [&](const PcdField& field) { return std::pair(field.offset, header_.stride); }))
            return;
        sink_->reserve(points);
        for (std::size_t i = 0; i < points; ++i) {
            job_.step(i, points);
            readPoint([&](const PcdField& field) { return body + i * header_.stride + field.offset; });
        }
        if (points < header_.points) refuseTooShort(header_.stride, available);
    }

    void readCompressed() {
        const std::size_t available = file_.size() - header_.bodyOffset;
        const std::byte* body = reinterpret_cast<const std::byte*>(file_.data()) + header_.bodyOffset;
        if (available < 8) job_.refuseByte(header_.bodyOffset, "the file ends before the sizes", "8 bytes");
        const auto packedSize = load<std::uint32_t>(body);
        const auto size = load<std::uint32_t>(body + 4);
        if (header_.points > size / header_.stride || header_.points * header_.stride != size)
            job_.refuseByte(
                header_.bodyOffset + 4, "the size of the points does not fit the header",
                std::to_string(header_.points) + " points of " + std::to_string(header_.stride) + " bytes");
        const std::size_t there = std::min<std::size_t>(packedSize, available - 8);
        const std::vector<std::byte> unpacked = unpackLzf({body + 8, there}, size);
        const std::size_t points = wholeColumns(unpacked.size());
        // Compressed files hold one field of all points after the other.
        if (points == header_.points && unpacked.size() == size && there == packedSize &&
            readAtOnce(unpacked.data(), [&](const PcdField& field) {
                return std::pair(field.offset * points, field.bytes());
            }))
            return;
        sink_->reserve(points);
        for (std::size_t i = 0; i < points; ++i) {
            job_.step(i, points);
            readPoint([&](const PcdField& field) {
                return unpacked.data() + field.offset * header_.points + i * field.bytes();
            });
        }
        if (there < packedSize)
            job_.refuseByte(header_.bodyOffset,
                            "the file ends after " + std::to_string(there) + " bytes of compressed points",
                            std::to_string(packedSize) + " bytes");
        if (unpacked.size() < size)
            job_.refuseByte(header_.bodyOffset + 8, "the compressed points are damaged", "LZF data");
    }

    /// All points by many threads; `place(field)` is where its first value lies and how far the next one is.
    template <class Place>
    bool readAtOnce(const std::byte* body, const Place& place) {
        RecordLayout layout;
        layout.columns.resize(header_.columns);
        for (std::size_t i = 0; i < header_.fields.size(); ++i) {
            const PcdField& field = header_.fields[i];
            if (field.count != 1) continue;
            const auto [offset, step] = place(field);
            const bool packed = i == packedField_ && sizeOf(field.type) == 4;
            layout.columns[field.column] = {PointField::none, packed ? ScalarType::uint32 : field.type,
                                            offset, step};
        }
        return sink_->addRecords(body, header_.points, std::move(layout), job_);
    }

    /// Compressed files hold one field of all points after the other: the points of which the first `bytes`
    /// bytes hold every field.
    std::size_t wholeColumns(std::size_t bytes) const {
        std::size_t points = header_.points;
        for (const PcdField& field : header_.fields) {
            if (field.count == 0) continue;
            const std::size_t begin = field.offset * header_.points;
            points = std::min(points, bytes < begin ? 0 : (bytes - begin) / field.bytes());
        }
        return points;
    }

    std::string_view file_;
    const PcdHeader& header_;
    ReadJob& job_;
    std::vector<double> row_;
    std::vector<bool> coordinate_;  ///< of the fields: x, y, z
    std::optional<std::size_t> packedField_;
    std::optional<PointSink> sink_;
    std::size_t holes_ = 0;
};

}  // namespace

PointCloud readPcdBody(std::string_view file, const PcdHeader& header, ReadJob& job) {
    return BodyReader(file, header, job).read();
}

}  // namespace vestige
