#include "core/io/formats/SbetFormat.h"

#include <algorithm>
#include <utility>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/SbetRecord.h"
#include "core/io/formats/UtmFrame.h"

namespace vestige {
namespace {

/// Further away from its zone's middle a trajectory is no survey, and the zone no sensible frame.
constexpr double kFurthest_deg = 30;

/// The record at a place that is inside the file; refuses positions that are not on Earth.
SbetRecord checkedRecord(std::span<const std::byte> bytes, std::size_t index, const ReadJob& job) {
    const std::size_t place = index * SbetRecord::kBytes;
    const SbetRecord record = sbetRecord(bytes.subspan(place));
    if (const char* problem = sbetProblem(record))
        job.refuseByte(place, std::string(problem) + " (record " + std::to_string(index + 1) + ")",
                       "time, latitude and longitude in radians, height in metres");
    return record;
}

UtmFrame frameOf(const SbetRecord& record) {
    return {degrees(record.latitude_rad), degrees(record.longitude_rad)};
}

void describeFrame(const UtmFrame& frame, FileInfo& info) {
    info.crs = frame.wkt();
    info.crsRecords = {frame.record()};
    info.metresPerUnit = 1;
}

void checkSize(std::span<const std::byte> bytes, const ReadJob& job) {
    if (bytes.size() < SbetRecord::kBytes)
        job.refuseByte(bytes.size(), "the file ends inside its first record",
                       "records of " + std::to_string(SbetRecord::kBytes) + " bytes");
}

struct Range {
    double least = 1e300, most = -1e300;
    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    std::string text(int decimals) const {
        return fixedText(least, decimals) + " to " + fixedText(most, decimals);
    }
};

class SbetReader {
  public:
    SbetReader(std::span<const std::byte> bytes, ReadJob& job) : bytes_(bytes), job_(job) {}

    LoadedGeometry read() {
        checkSize(bytes_, job_);
        const std::size_t records = bytes_.size() / SbetRecord::kBytes;
        const std::size_t rest = bytes_.size() % SbetRecord::kBytes;
        const UtmFrame frame = frameOf(checkedRecord(bytes_, 0, job_));
        builder_.reserve(records);
        job_.untilDamage(
            [&] {
                for (std::size_t i = 0; i < records; ++i) add(i, records, frame);
                if (rest != 0)
                    job_.refuseByte(bytes_.size() - rest, "the file ends inside a record",
                                    "records of " + std::to_string(SbetRecord::kBytes) + " bytes");
            },
            [&] {
                return WholePart{builder_.size(),
                                 firstOf(builder_.size(), records + (rest != 0 ? 1 : 0), "record")};
            });
        return finish(frame);
    }

  private:
    void add(std::size_t i, std::size_t records, const UtmFrame& frame) {
        job_.step(i, records);
        const SbetRecord record = checkedRecord(bytes_, i, job_);
        const double latitude = degrees(record.latitude_rad);
        const double longitude = degrees(record.longitude_rad);
        if (std::abs(frame.fromMeridian_deg(longitude)) > kFurthest_deg)
            job_.refuseByte(i * SbetRecord::kBytes,
                            "record " + std::to_string(i + 1) + " is far from the zone of the first one",
                            "a trajectory within " + fixedText(kFurthest_deg, 0) + " degrees of longitude");
        std::vector<double>& times = builder_.attributes().gpsTime;
        if (!times.empty() && record.time < times.back()) ++backwards_;
        times.push_back(record.time);
        latitudes_.add(latitude);
        longitudes_.add(longitude);
        const Eigen::Vector2d place = frame.project(latitude, longitude);
        builder_.add({place.x(), place.y(), record.height_m});
    }

    LoadedGeometry finish(const UtmFrame& frame) {
        if (backwards_ > 0)
            job_.warn("the time goes back at " + counted(backwards_, "record") +
                      "; the records are in the order of the file");
        job_.warn("velocities, attitude and rates of the trajectory are not kept");
        LoadedGeometry result =
            loaded({std::move(builder_).build(), {}}, "SBET",
                   frame.name() + ", heights above the ellipsoid; latitude " + latitudes_.text(6) +
                       ", longitude " + longitudes_.text(6) + " degrees",
                   job_);
        describeFrame(frame, result.info);
        return result;
    }

    std::span<const std::byte> bytes_;
    ReadJob& job_;
    PointCloudBuilder builder_;
    Range latitudes_, longitudes_;
    std::size_t backwards_ = 0;
};

}  // namespace

bool SbetFormat::recognises(std::span<const std::byte> head, std::string_view extension) const {
    return (extension == "sbet" || extension == "out") && looksLikeSbet(head);
}

Result<FileInfo> SbetFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        const ReadJob job(file, control);
        checkSize(content->bytes(), job);
        const std::size_t records = content->bytes().size() / SbetRecord::kBytes;
        const SbetRecord first = checkedRecord(content->bytes(), 0, job);
        const SbetRecord last = checkedRecord(content->bytes(), records - 1, job);
        const UtmFrame frame = frameOf(first);
        FileInfo info;
        info.path = file;
        info.format = "SBET";
        info.version = frame.name() + ", heights above the ellipsoid";
        info.points = records;
        info.attributes = {"gps_time"};
        info.timeSpan = std::minmax(first.time, last.time);
        describeFrame(frame, info);
        return info;
    });
}

Result<LoadedGeometry> SbetFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                        const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        return SbetReader(content->bytes(), job).read();
    });
}

}  // namespace vestige
