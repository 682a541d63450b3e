#include "core/io/formats/LazReader.h"

#include <laszip/laszip_api.h>
#include <istream>
#include <memory>
#include <streambuf>

#include "core/io/formats/LazCheck.h"

namespace vestige {
namespace {

/// A stream over a file in memory whose beginning is replaced by `prefix`.
class PatchedBuffer : public std::streambuf {
  public:
    PatchedBuffer(std::vector<std::byte> prefix, std::span<const std::byte> file)
        : prefix_(std::move(prefix)), file_(file) {
        show(prefix_, 0);
    }

  protected:
    int_type underflow() override {
        const std::size_t place = position();
        if (place >= file_.size()) return traits_type::eof();
        seek(place);
        return traits_type::to_int_type(*gptr());
    }
    pos_type seekoff(off_type offset, std::ios_base::seekdir direction, std::ios_base::openmode) override {
        const off_type base = direction == std::ios_base::beg   ? 0
                              : direction == std::ios_base::cur ? static_cast<off_type>(position())
                                                                : static_cast<off_type>(file_.size());
        const off_type target = base + offset;
        if (target < 0 || target > static_cast<off_type>(file_.size())) return pos_type(off_type(-1));
        seek(static_cast<std::size_t>(target));
        return target;
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }

  private:
    std::size_t position() const { return shownFrom_ + static_cast<std::size_t>(gptr() - eback()); }

    void seek(std::size_t place) {
        if (place < prefix_.size()) {
            show(prefix_, 0);
            gbump64(place);
        } else {
            show(file_.subspan(prefix_.size()), prefix_.size());
            gbump64(place - prefix_.size());
        }
    }
    void show(std::span<const std::byte> part, std::size_t from) {
        char* begin = const_cast<char*>(reinterpret_cast<const char*>(part.data()));
        shownFrom_ = from;
        setg(begin, begin, begin + part.size());
    }
    void gbump64(std::size_t count) { setg(eback(), eback() + count, egptr()); }

    std::vector<std::byte> prefix_;
    std::span<const std::byte> file_;
    std::size_t shownFrom_ = 0;
};

struct ReaderCloser {
    void operator()(void* reader) const {
        laszip_close_reader(reader);
        laszip_destroy(reader);
    }
};

/// LASzip's reader on a checked file.
class LazReader {
  public:
    LazReader(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job)
        : job_(job), buffer_(lazPrefix(file, header), file), stream_(&buffer_) {
        laszip_POINTER reader = nullptr;
        if (laszip_create(&reader) != 0) job.refuse("LASzip cannot be started");
        reader_.reset(reader);
        // Points of formats 6 and later, folded into older formats by LASzip 2, come out as what they were.
        laszip_request_compatibility_mode(reader, 1);
        laszip_BOOL compressed = 0;
        check(laszip_open_reader_stream(reader, stream_, &compressed));
        check(laszip_get_point_pointer(reader, &point_));
    }

    void next() { check(laszip_read_point(reader_.get())); }

    const laszip_point& point() const { return *point_; }

  private:
    void check(laszip_I32 failed) const {
        if (failed == 0) return;
        laszip_CHAR* message = nullptr;
        laszip_get_error(reader_.get(), &message);
        job_.refuse(
            std::string("the compressed points are damaged: ") + (message ? message : "LASzip gives up"),
            "a whole LAZ file");
    }

    const ReadJob& job_;
    PatchedBuffer buffer_;
    std::istream stream_;
    std::unique_ptr<void, ReaderCloser> reader_;
    laszip_point* point_ = nullptr;
};

void decode(const laszip_point& packed, const LasHeader& header, LasPoint& point) {
    point.position = Eigen::Vector3d(packed.X * header.scale.x(), packed.Y * header.scale.y(),
                                     packed.Z * header.scale.z()) +
                     header.offset;
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

void readLazPoints(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job,
                   const LasPointHandler& handle) {
    checkLaz(file, header, job);
    LazReader reader(file, header, job);
    LasPoint point;
    for (std::uint64_t i = 0; i < header.points; ++i) {
        job.step(i, header.points);
        reader.next();
        decode(reader.point(), header, point);
        handle(point);
    }
}

}  // namespace vestige
