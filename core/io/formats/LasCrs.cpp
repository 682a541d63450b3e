#include "core/io/formats/LasCrs.h"

#include <algorithm>

#include "core/base/CleanText.h"
#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::uint16_t kMathTransform = 2111;
constexpr std::uint16_t kWkt = 2112;
constexpr std::uint16_t kGeoKeys = 34735;
constexpr std::uint16_t kGeoDoubles = 34736;
constexpr std::uint16_t kGeoAscii = 34737;

const CrsRecord* find(const std::vector<CrsRecord>& records, std::uint16_t id) {
    const auto found = std::find_if(records.begin(), records.end(),
                                    [&](const CrsRecord& record) { return record.recordId == id; });
    return found == records.end() ? nullptr : &*found;
}

/// Up to the first zero byte; WKT may stand on several lines, which become one.
std::string printable(const std::uint8_t* begin, std::size_t size) {
    std::string_view bytes(reinterpret_cast<const char*>(begin), size);
    std::string joined(bytes.substr(0, bytes.find('\0')));
    std::replace_if(
        joined.begin(), joined.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    std::string text = cleanText(joined, joined.size());
    while (!text.empty() && (text.back() == ' ' || text.back() == '|')) text.pop_back();
    return text;
}

std::uint16_t wordAt(const CrsRecord& record, std::size_t word) {
    return load<std::uint16_t>(reinterpret_cast<const std::byte*>(record.bytes.data()) + 2 * word);
}

/// GeoTIFF 1.0, section 2.4: a header of four words (version, revision, minor, number of keys), then four
/// words a key (id, where its value is, how many, value or index).
std::string keysInWords(const CrsRecord& keys, const CrsRecord* ascii, ReadJob& job) {
    const std::size_t words = keys.bytes.size() / 2;
    const std::size_t count = words >= 4 ? wordAt(keys, 3) : 0;
    if (words < 4 || count > words / 4 - 1) {
        job.warn("the GeoTIFF keys are damaged; the coordinate reference system is unknown");
        return {};
    }
    std::string text;
    const auto append = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    for (std::size_t key = 1; key <= count; ++key) {
        const std::uint16_t id = wordAt(keys, 4 * key);
        const std::uint16_t where = wordAt(keys, 4 * key + 1);
        const std::size_t length = wordAt(keys, 4 * key + 2);
        const std::size_t value = wordAt(keys, 4 * key + 3);
        const std::string code =
            value == 32767 ? std::string("user defined") : "EPSG:" + std::to_string(value);
        if (id == 2048) append("geographic " + code);
        if (id == 3072) append("projected " + code);
        if (id == 4096) append("vertical " + code);
        if (id == 3076) append("unit " + code);
        if (where != kGeoAscii || !ascii || (id != 1026 && id != 2049 && id != 3073 && id != 4097)) continue;
        if (value > ascii->bytes.size() || length > ascii->bytes.size() - value) continue;
        if (const std::string cited = printable(ascii->bytes.data() + value, length); !cited.empty())
            append('"' + cited + '"');
    }
    return text;
}

}  // namespace

std::vector<CrsRecord> crsRecords(const LasHeader& header) {
    std::vector<CrsRecord> kept;
    for (const LasRecord& record : header.records) {
        if (record.userId != "LASF_Projection") continue;
        const std::uint16_t id = record.recordId;
        if (id != kMathTransform && id != kWkt && id != kGeoKeys && id != kGeoDoubles && id != kGeoAscii)
            continue;
        const auto* begin = reinterpret_cast<const std::uint8_t*>(record.content.data());
        kept.push_back(
            {record.userId, id, record.description, {begin, begin + record.content.size()}, record.extended});
    }
    return kept;
}

std::string crsText(const std::vector<CrsRecord>& records, ReadJob& job) {
    if (const CrsRecord* wkt = find(records, kWkt); wkt && !wkt->bytes.empty())
        return printable(wkt->bytes.data(), wkt->bytes.size());
    if (const CrsRecord* keys = find(records, kGeoKeys))
        return keysInWords(*keys, find(records, kGeoAscii), job);
    return {};
}

}  // namespace vestige
