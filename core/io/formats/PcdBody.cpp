#include "core/io/formats/PcdBody.h"

#include <bit>
#include <cmath>
#include <optional>

#include "core/io/Bytes.h"
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
        for (std::size_t i = 0; i < header.fields.size(); ++i) {
            if (header.fields[i].count != 1) continue;
            columns[header.fields[i].column] = meanings[i];
            if (meanings[i] == PointField::packedColor) packedField_ = i;
        }
        sink_.emplace(columns, depth);
    }

    PointCloud read() {
        switch (header_.encoding) {
            case PcdEncoding::ascii:
                readAscii();
                break;
            case PcdEncoding::binary:
                readBinary();
                break;
            case PcdEncoding::compressed:
                readCompressed();
                break;
        }
        if (holes_ > 0) job_.warn(counted(holes_, "point") + " without finite coordinates left out");
        if (header_.movedViewpoint) job_.warn("VIEWPOINT is not applied to the points");
        return std::move(*sink_).build();
    }

  private:
    void addRow() {
        if (!sink_->add(row_.data())) ++holes_;
    }

    void checkCount(std::size_t smallest, std::size_t available) {
        if (header_.points > available / smallest)
            job_.refuseByte(header_.bodyOffset,
                            "the header promises " + std::to_string(header_.points) +
                                " points, but the file ends too early for them",
                            std::to_string(smallest) + " bytes or more for each, " +
                                std::to_string(available) + " are left");
        sink_->reserve(header_.points);
    }

    /// A packed colour written as text: the integer itself, or a float whose bits are the integer.
    static double packedFromText(double value) {
        if (std::isnan(value)) return 0;
        if (std::abs(value) >= 1) return value < 0 || value > 4294967295.0 ? 0 : std::floor(value);
        return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    }

    void readAscii() {
        TextScanner scanner(file_, header_.bodyOffset, header_.bodyLine);
        checkCount(2 * header_.columns, file_.size() - scanner.offset() + 1);
        std::size_t done = 0;
        while (done < header_.points) {
            const std::size_t line = scanner.line();
            if (scanner.atEnd())
                job_.refuseLine(line, "the file ends after " + counted(done, "point"),
                                std::to_string(header_.points) + " points as the header says");
            const std::string_view text = scanner.nextLine();
            if (trimmed(text).empty()) continue;
            job_.step(done++, header_.points);
            readRow(text, line);
            addRow();
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
        addRow();
    }

    void readBinary() {
        const std::size_t available = file_.size() - header_.bodyOffset;
        checkCount(header_.stride, available);
        const std::byte* body = reinterpret_cast<const std::byte*>(file_.data()) + header_.bodyOffset;
        for (std::size_t i = 0; i < header_.points; ++i) {
            job_.step(i, header_.points);
            readPoint([&](const PcdField& field) { return body + i * header_.stride + field.offset; });
        }
    }

    void readCompressed() {
        const std::size_t available = file_.size() - header_.bodyOffset;
        const std::byte* body = reinterpret_cast<const std::byte*>(file_.data()) + header_.bodyOffset;
        if (available < 8) job_.refuseByte(header_.bodyOffset, "the file ends before the sizes", "8 bytes");
        const auto packedSize = load<std::uint32_t>(body);
        const auto size = load<std::uint32_t>(body + 4);
        if (packedSize > available - 8)
            job_.refuseByte(
                header_.bodyOffset,
                "the file ends after " + std::to_string(available - 8) + " bytes of compressed points",
                std::to_string(packedSize) + " bytes");
        if (header_.points > size / header_.stride || header_.points * header_.stride != size)
            job_.refuseByte(
                header_.bodyOffset + 4, "the size of the points does not fit the header",
                std::to_string(header_.points) + " points of " + std::to_string(header_.stride) + " bytes");
        const auto unpacked = unpackLzf({body + 8, packedSize}, size);
        if (!unpacked)
            job_.refuseByte(header_.bodyOffset + 8, "the compressed points are damaged", "LZF data");
        sink_->reserve(header_.points);
        for (std::size_t i = 0; i < header_.points; ++i) {
            job_.step(i, header_.points);
            // Compressed files hold one field of all points after the other.
            readPoint([&](const PcdField& field) {
                return unpacked->data() + field.offset * header_.points + i * field.bytes();
            });
        }
    }

    std::string_view file_;
    const PcdHeader& header_;
    ReadJob& job_;
    std::vector<double> row_;
    std::optional<std::size_t> packedField_;
    std::optional<PointSink> sink_;
    std::size_t holes_ = 0;
};

}  // namespace

PointCloud readPcdBody(std::string_view file, const PcdHeader& header, ReadJob& job) {
    return BodyReader(file, header, job).read();
}

}  // namespace vestige
