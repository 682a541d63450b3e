#include "core/io/formats/LazWriter.h"

#include <laszip/laszip_api.h>

#include <string>

#include "core/base/Result.h"
#include "core/io/Bytes.h"
#include "core/io/formats/LasEncode.h"

namespace vestige {

struct LazWriter::State {
    laszip_POINTER writer = nullptr;
    laszip_point* point = nullptr;
    bool colored = false;
    bool opened = false;

    void check(laszip_I32 failed) const {
        if (failed == 0) return;
        laszip_CHAR* message = nullptr;
        if (writer) laszip_get_error(writer, &message);
        const std::string reason = message ? message : "it cannot be started";
        throw ErrorException{{ErrorCode::output, "LASzip cannot pack the points: " + reason, {}, {}}};
    }
};

LazWriter::LazWriter(bool colored) : state_(std::make_unique<State>()) {
    state_->colored = colored;
    state_->check(laszip_create(&state_->writer));
    laszip_header* header = nullptr;
    state_->check(laszip_get_header_pointer(state_->writer, &header));
    header->version_major = 1;
    header->version_minor = 4;
    header->header_size = kLasHeaderSize;
    header->offset_to_point_data = kLasHeaderSize;
    state_->check(laszip_set_point_type_and_size(state_->writer, colored ? 7 : 6,
                                                 static_cast<laszip_U16>(lasRecordLength(colored))));
    state_->check(laszip_request_native_extension(state_->writer, 1));
    state_->check(laszip_get_point_pointer(state_->writer, &state_->point));
}

LazWriter::~LazWriter() {
    if (state_->opened) laszip_close_writer(state_->writer);
    if (state_->writer) laszip_destroy(state_->writer);
}

std::vector<std::byte> LazWriter::record() {
    laszip_U8* bytes = nullptr;
    laszip_U32 size = 0;
    state_->check(laszip_create_laszip_vlr(state_->writer, &bytes, &size));
    const auto* begin = reinterpret_cast<const std::byte*>(bytes);
    return {begin, begin + size};
}

void LazWriter::open(std::ostream& stream) {
    state_->check(laszip_open_writer_stream(state_->writer, stream, 1, 1));
    state_->opened = true;
}

void LazWriter::add(std::span<const std::byte> record) {
    laszip_point& point = *state_->point;
    const std::byte* at = record.data();
    point.X = load<std::int32_t>(at);
    point.Y = load<std::int32_t>(at + 4);
    point.Z = load<std::int32_t>(at + 8);
    point.intensity = load<std::uint16_t>(at + 12);
    const auto returns = load<std::uint8_t>(at + 14);
    point.extended_point_type = 1;
    point.extended_return_number = returns & 15;
    point.extended_number_of_returns = returns >> 4;
    const auto flags = load<std::uint8_t>(at + 15);
    point.extended_classification_flags = flags & 15;
    // LASzip wants the older formats' copies of them to agree.
    point.synthetic_flag = flags & 1;
    point.keypoint_flag = flags >> 1 & 1;
    point.withheld_flag = flags >> 2 & 1;
    point.extended_scanner_channel = flags >> 4 & 3;
    point.scan_direction_flag = flags >> 6 & 1;
    point.edge_of_flight_line = flags >> 7;
    point.extended_classification = load<std::uint8_t>(at + 16);
    point.user_data = load<std::uint8_t>(at + 17);
    point.extended_scan_angle = load<std::int16_t>(at + 18);
    point.point_source_ID = load<std::uint16_t>(at + 20);
    point.gps_time = load<double>(at + 22);
    if (state_->colored)
        for (std::size_t channel = 0; channel < 3; ++channel)
            point.rgb[channel] = load<std::uint16_t>(at + 30 + 2 * channel);
    state_->check(laszip_write_point(state_->writer));
}

void LazWriter::close() {
    state_->opened = false;
    state_->check(laszip_close_writer(state_->writer));
}

}  // namespace vestige
