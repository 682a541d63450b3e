#include "core/io/formats/LasHeader.h"

#include <algorithm>

#include "core/io/Bytes.h"
#include "core/io/Coordinates.h"

namespace vestige {
namespace {

constexpr std::size_t kSmallestHeader = 227;
constexpr std::size_t kHeader14 = 375;
constexpr std::size_t kRecordHeader = 54;
constexpr std::size_t kExtendedRecordHeader = 60;
/// The 32 bits of a coordinate would span a few micrometres, or more than the Earth's orbit.
constexpr double kFinestScale = 1e-15;
constexpr double kCoarsestScale = 1e6;

/// A text field: up to the first zero byte, what is not printable shown as '?'.
std::string fieldText(std::span<const std::byte> bytes) {
    std::string text;
    for (const std::byte byte : bytes) {
        const auto c = static_cast<char>(byte);
        if (c == 0) break;
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

class HeaderParser {
  public:
    HeaderParser(std::span<const std::byte> file, ReadJob& job, bool salvage)
        : file_(file), job_(job), salvage_(salvage) {}

    LasHeader parse() {
        if (file_.size() < 4 || fieldText(file_.first(4)) != "LASF")
            job_.refuseByte(0, "this is no LAS file", "the signature LASF");
        if (file_.size() < kSmallestHeader)
            job_.refuseByte(file_.size(), "the file ends inside the header", "227 bytes of header or more");
        parseVersion();
        parsePlaces();
        parsePointFormat();
        parsePointCount();
        parseGrid();
        parseRecords();
        if (header_.versionMinor >= 4) parseExtendedRecords();
        return std::move(header_);
    }

  private:
    template <class Number>
    Number at(std::size_t offset) const {
        return load<Number>(file_.data() + offset);
    }

    void parseVersion() {
        const int major = at<std::uint8_t>(24);
        header_.versionMinor = at<std::uint8_t>(25);
        if (major != 1 || header_.versionMinor > 4)
            job_.refuseByte(24,
                            "LAS version " + std::to_string(major) + "." +
                                std::to_string(header_.versionMinor) + " is unknown",
                            "1.0 to 1.4");
        header_.globalEncoding = header_.versionMinor >= 2 ? at<std::uint16_t>(6) : 0;
        header_.generatingSoftware = fieldText(file_.subspan(58, 32));
        header_.creationDay = at<std::uint16_t>(90);
        header_.creationYear = at<std::uint16_t>(92);
    }

    void parsePlaces() {
        header_.headerSize = at<std::uint16_t>(94);
        const std::size_t smallest = header_.versionMinor == 4   ? kHeader14
                                     : header_.versionMinor == 3 ? 235
                                                                 : kSmallestHeader;
        if (header_.headerSize < smallest || header_.headerSize > file_.size())
            job_.refuseByte(94, "the header is said to have " + counted(header_.headerSize, "byte"),
                            std::to_string(smallest) + " or more, and no more than the file has");
        header_.pointOffset = at<std::uint32_t>(96);
        if (header_.pointOffset < header_.headerSize || header_.pointOffset > file_.size())
            job_.refuseByte(96, "the points are said to begin at byte " + std::to_string(header_.pointOffset),
                            "a place behind the header and inside the file of " +
                                std::to_string(file_.size()) + " bytes");
    }

    void parsePointFormat() {
        const int format = at<std::uint8_t>(104);
        header_.compressed = (format & 0x80) != 0;
        header_.pointFormat = format & 0x3f;
        if (header_.pointFormat > 10)
            job_.refuseByte(104, "point format " + std::to_string(header_.pointFormat) + " is unknown",
                            "0 to 10");
        header_.recordLength = at<std::uint16_t>(105);
        if (const std::size_t size = lasPointLayout(header_.pointFormat).size; header_.recordLength < size)
            job_.refuseByte(
                105, "a point is said to have " + counted(header_.recordLength, "byte"),
                std::to_string(size) + " or more for point format " + std::to_string(header_.pointFormat));
    }

    void parsePointCount() {
        header_.points = at<std::uint32_t>(107);
        if (header_.versionMinor >= 4)
            if (const auto extended = at<std::uint64_t>(247); extended != 0) header_.points = extended;
        const std::size_t available = file_.size() - header_.pointOffset;
        header_.promisedPoints = header_.points;
        if (header_.compressed || header_.points <= available / header_.recordLength) return;
        header_.points = available / header_.recordLength;
        if (!salvage_)
            job_.refuseByte(header_.pointOffset,
                            "the header promises " + std::to_string(header_.promisedPoints) + " points of " +
                                std::to_string(header_.recordLength) + " bytes, but the file has room for " +
                                std::to_string(header_.points),
                            "a file that is whole");
    }

    void parseGrid() {
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = static_cast<std::size_t>(axis);
            header_.scale[axis] = at<double>(131 + 8 * place);
            header_.offset[axis] = at<double>(155 + 8 * place);
            header_.bounds.max[axis] = at<double>(179 + 16 * place);
            header_.bounds.min[axis] = at<double>(187 + 16 * place);
        }
        // Also catches what is no number.
        const auto scale = header_.scale.array().abs();
        if (!(scale >= kFinestScale && scale <= kCoarsestScale).all())
            job_.refuseByte(131, "a scale factor is zero, no finite number or absurd",
                            "a scale such as 0.001");
        if (!isUsable(header_.offset))
            job_.refuseByte(155, "an offset is no finite number, or farther from 0 than any place on Earth",
                            "offsets up to 1e10");
    }

    void parseRecords() {
        const auto count = at<std::uint32_t>(100);
        std::size_t place = header_.headerSize;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::size_t left = header_.pointOffset - place;
            const std::size_t length = left < kRecordHeader ? 0 : at<std::uint16_t>(place + 20);
            if (left < kRecordHeader || left - kRecordHeader < length) {
                job_.warn("byte " + std::to_string(place) + ": the header promises " +
                          counted(count, "record") + ", but there is room for " + std::to_string(i));
                return;
            }
            addRecord(place, kRecordHeader, length);
            place += kRecordHeader + length;
        }
    }

    void parseExtendedRecords() {
        const auto start = at<std::uint64_t>(235);
        const auto count = at<std::uint32_t>(243);
        std::size_t place = start;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::size_t left = place <= file_.size() ? file_.size() - place : 0;
            const std::uint64_t length = left < kExtendedRecordHeader ? 0 : at<std::uint64_t>(place + 20);
            if (left < kExtendedRecordHeader || left - kExtendedRecordHeader < length) {
                job_.warn("byte " + std::to_string(place) + ": the header promises " +
                          counted(count, "extended record") + ", but there is room for " + std::to_string(i));
                return;
            }
            addRecord(place, kExtendedRecordHeader, length);
            header_.records.back().extended = true;
            place += kExtendedRecordHeader + length;
        }
    }

    void addRecord(std::size_t place, std::size_t recordHeader, std::size_t length) {
        LasRecord& record = header_.records.emplace_back();
        record.userId = fieldText(file_.subspan(place + 2, 16));
        record.recordId = at<std::uint16_t>(place + 18);
        record.description = fieldText(file_.subspan(place + recordHeader - 32, 32));
        record.content = file_.subspan(place + recordHeader, length);
    }

    std::span<const std::byte> file_;
    ReadJob& job_;
    bool salvage_;
    LasHeader header_;
};

}  // namespace

const LasPointLayout& lasPointLayout(int pointFormat) {
    static constexpr std::array<LasPointLayout, 11> kLayouts{{{20, 0, 0, false},
                                                              {28, 20, 0, false},
                                                              {26, 0, 20, false},
                                                              {34, 20, 28, false},
                                                              {57, 20, 0, false},
                                                              {63, 20, 28, false},
                                                              {30, 22, 0, true},
                                                              {36, 22, 30, true},
                                                              {38, 22, 30, true},
                                                              {59, 22, 0, true},
                                                              {67, 22, 30, true}}};
    return kLayouts.at(static_cast<std::size_t>(pointFormat));
}

const LasRecord* LasHeader::find(std::string_view userId, std::uint16_t recordId) const {
    const auto found = std::find_if(records.begin(), records.end(), [&](const LasRecord& record) {
        return record.recordId == recordId && record.userId == userId;
    });
    return found == records.end() ? nullptr : &*found;
}

LasHeader parseLasHeader(std::span<const std::byte> file, ReadJob& job, bool salvage) {
    return HeaderParser(file, job, salvage).parse();
}

}  // namespace vestige
