#include "core/io/formats/LazReader.h"

#include <laszip/laszip_api.h>
#include <algorithm>
#include <istream>
#include <memory>

#include "core/io/formats/LayeredReader.h"
#include "core/io/formats/PatchedBuffer.h"

namespace vestige {
namespace {

constexpr std::size_t kBlock = 256;
constexpr laszip_U32 kDrawn = laszip_DECOMPRESS_SELECTIVE_Z | laszip_DECOMPRESS_SELECTIVE_CLASSIFICATION |
                              laszip_DECOMPRESS_SELECTIVE_FLAGS | laszip_DECOMPRESS_SELECTIVE_INTENSITY |
                              laszip_DECOMPRESS_SELECTIVE_RGB;

struct ReaderCloser {
    void operator()(void* reader) const {
        laszip_close_reader(reader);
        laszip_destroy(reader);
    }
};

/// LASzip's reader on a checked file.
class LazReader {
  public:
    LazReader(std::span<const std::byte> file, const LasHeader& header, const LazPlan& plan, bool drawn,
              const ReadJob& job)
        : job_(job), buffer_(lazPrefix(file, header, plan), file), stream_(&buffer_) {
        laszip_POINTER reader = nullptr;
        if (laszip_create(&reader) != 0) job.refuse("LASzip cannot be started");
        reader_.reset(reader);
        // Points of formats 6 and later, folded into older formats by LASzip 2, come out as what they were.
        laszip_request_compatibility_mode(reader, 1);
        if (drawn) check(laszip_decompress_selective(reader, kDrawn));
        laszip_BOOL compressed = 0;
        check(laszip_open_reader_stream(reader, stream_, &compressed));
        check(laszip_get_point_pointer(reader, &point_));
    }

    void seek(std::uint64_t point) {
        check(laszip_seek_point(reader_.get(), static_cast<laszip_I64>(point)));
    }
    bool next() { return laszip_read_point(reader_.get()) == 0; }
    const laszip_point& point() const { return *point_; }

    void check(laszip_I32 failed) const {
        if (failed != 0) refuse();
    }
    [[noreturn]] void refuse() const {
        laszip_CHAR* message = nullptr;
        laszip_get_error(reader_.get(), &message);
        job_.refuse(
            std::string("the compressed points are damaged: ") + (message ? message : "LASzip gives up"),
            "a whole LAZ file");
    }

  private:
    const ReadJob& job_;
    PatchedBuffer buffer_;
    std::istream stream_;
    std::unique_ptr<void, ReaderCloser> reader_;
    laszip_point* point_ = nullptr;
};

void decode(const laszip_point& packed, LasPoint& point) {
    point.steps = {packed.X, packed.Y, packed.Z};
    point.intensity = packed.intensity;
    if (packed.extended_point_type != 0) {
        point.returnNumber = packed.extended_return_number;
        point.returnCount = packed.extended_number_of_returns;
        point.classification = packed.extended_classification;
        point.withheld = (packed.extended_classification_flags & 4) != 0;
    } else {
        point.returnNumber = packed.return_number;
        point.returnCount = packed.number_of_returns;
        point.classification = packed.classification;
        point.withheld = packed.withheld_flag != 0;
    }
    point.pointSource = packed.point_source_ID;
    point.gpsTime = packed.gps_time;
    point.color = {packed.rgb[0], packed.rgb[1], packed.rgb[2]};
}

}  // namespace

void readLazPoints(std::span<const std::byte> file, const LasHeader& header, const LazPlan& plan, bool drawn,
                   std::uint64_t begin, std::uint64_t end, const ReadJob& job,
                   const LasBlockHandler& handle) {
    if (!plan.chunks.empty()) {
        readLayeredPoints(file, header, plan, drawn, begin, end, job, handle);
        return;
    }
    LazReader reader(file, header, plan, drawn, job);
    if (begin > 0) reader.seek(begin);
    std::array<LasPoint, kBlock> block;
    for (std::uint64_t first = begin; first < end; first += kBlock) {
        const auto many = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - first));
        for (std::size_t i = 0; i < many; ++i) {
            if (!reader.next()) {
                handle(first, std::span(block).first(i));
                reader.refuse();
            }
            decode(reader.point(), block[i]);
        }
        handle(first, std::span(block).first(many));
    }
}

}  // namespace vestige
