#include "core/io/formats/E57Points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/formats/E57Rows.h"

namespace vestige {
namespace {

constexpr std::size_t kChunk = 32768;

/// The attributes that any of the scans has: points of the others get zeros.
struct Attributes {
    bool intensity = false, color = false, classification = false, time = false, normal = false;
    bool source = false, returnNumber = false, returnCount = false;

    explicit Attributes(const E57Document& document) {
        for (const E57Scan& scan : document.scans) {
            intensity |= scan.has(E57Role::intensity);
            color |= scan.hasAll({E57Role::red, E57Role::green, E57Role::blue});
            classification |= scan.has(E57Role::classification);
            time |= scan.has(E57Role::time);
            normal |= scan.hasAll({E57Role::normalX, E57Role::normalY, E57Role::normalZ});
            source |= scan.has(E57Role::pointSource);
            returnNumber |= scan.has(E57Role::returnIndex);
            returnCount |= scan.has(E57Role::returnCount);
        }
        source |= document.scans.size() > 1;
    }

    void leaveUndrawn() { classification = time = source = returnNumber = returnCount = false; }
};

class Reader {
  public:
    Reader(const E57Pages& pages, E57Document& document, const ReadOptions& options, std::string& damage,
           ReadJob& job)
        : pages_(pages),
          document_(document),
          options_(options),
          damage_(damage),
          job_(job),
          drawnOnly_(options.attributes == ReadOptions::Attributes::drawn),
          attributes_(document) {
        if (drawnOnly_) attributes_.leaveUndrawn();
        for (const E57Scan& scan : document.scans) total_ += scan.records;
    }

    PointCloud read() {
        for (std::size_t i = 0; i < document_.scans.size(); ++i) readScan(i);
        if (invalid_ > 0)
            job_.warn(counted(invalid_, "record") +
                      " without a position left out: the scanner got no echo there");
        if (notFinite_ > 0) job_.warn(counted(notFinite_, "point") + " without finite coordinates left out");
        return std::move(builder_).build();
    }

  private:
    void readScan(std::size_t place) {
        E57Scan& scan = document_.scans[place];
        const E57Streams streams(pages_, scan, options_.salvage, job_);
        if (!streams.damage().empty())
            damage_ += (damage_.empty() ? "" : "; ") + ("scan " + std::to_string(place + 1)) + ": " +
                       std::to_string(streams.records()) + " of " + counted(scan.records, "point") +
                       " could be read: " + streams.damage();
        if (options_.wholeFile()) reserve(streams.records());
        scan.info.points = 0;
        const std::size_t firstPoint = builder_.size();
        leastReturn_ = 255;
        returnIsCount_ = false;
        const std::size_t wave = 2 * static_cast<std::size_t>(std::max(1, threadCount()));
        std::vector<E57Rows> rows(wave, E57Rows(scan, drawnOnly_));
        for (std::uint64_t first = 0; first < streams.records(); first += wave * kChunk) {
            job_.report(done_ + first, total_);
            const std::uint64_t count = std::min<std::uint64_t>(wave * kChunk, streams.records() - first);
            parallelChunks(count, kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                rows[chunk].decode(streams, first + begin, end - begin);
            });
            for (std::size_t chunk = 0; chunk * kChunk < count; ++chunk)
                append(rows[chunk], static_cast<std::uint16_t>(std::min<std::size_t>(place + 1, 65535)),
                       scan);
        }
        done_ += scan.records;
        countReturnsFromOne(firstPoint);
    }

    /// E57 numbers returns from 0; las2e57 copies the numbers of LAS, from 1.
    void countReturnsFromOne(std::size_t firstPoint) {
        if (leastReturn_ < 1 || !returnIsCount_) return;
        auto& numbers = builder_.attributes().returnNumber;
        for (std::size_t i = firstPoint; i < numbers.size(); ++i)
            numbers[i] = static_cast<std::uint8_t>(numbers[i] - 1);
        job_.warn("the returns are numbered from 1 in the file, which the standard counts from 0");
    }

    void seeReturn(const E57Rows& rows, std::size_t i) {
        if (!rows.has(E57Role::returnIndex) || !rows.has(E57Role::returnCount)) return;
        const double number = rows.value(E57Role::returnIndex, i);
        leastReturn_ = std::min(leastReturn_, number);
        returnIsCount_ |= number == rows.value(E57Role::returnCount, i);
    }

    void reserve(std::uint64_t more) { builder_.reserve(builder_.size() + more); }

    void append(const E57Rows& rows, std::uint16_t number, E57Scan& scan) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!rows.valid(i)) {
                ++invalid_;
                continue;
            }
            const Eigen::Vector3d point = rows.point(i);
            if (!point.allFinite()) {
                ++notFinite_;
                continue;
            }
            ++scan.info.points;
            seeReturn(rows, i);
            if (options_.box && !((point.array() >= options_.box->min.array()).all() &&
                                  (point.array() <= options_.box->max.array()).all()))
                continue;
            if (met_++ % std::max<std::uint32_t>(1, options_.keepEvery) != 0) continue;
            builder_.add(point);
            appendAttributes(rows, i, number);
        }
    }

    void appendAttributes(const E57Rows& rows, std::size_t i, std::uint16_t number) {
        PointAttributes& to = builder_.attributes();
        if (attributes_.intensity)
            to.intensity.push_back(rows.has(E57Role::intensity) ? rows.intensity(i) : 0.0F);
        if (attributes_.color) to.color.push_back(rows.hasColor() ? rows.color(i) : Color{});
        if (attributes_.normal)
            to.normal.push_back(rows.hasNormal() ? rows.normal(i) : Eigen::Vector3f::Zero());
        if (attributes_.classification)
            to.classification.push_back(byteOf(rows, E57Role::classification, i, 0));
        if (attributes_.time)
            to.gpsTime.push_back(rows.has(E57Role::time) ? rows.time(i)
                                                         : std::numeric_limits<double>::quiet_NaN());
        if (attributes_.source)
            to.pointSource.push_back(
                document_.scans.size() > 1 ? number : rows.whole<std::uint16_t>(E57Role::pointSource, i));
        // E57 numbers returns from 0, LAS and Vestige from 1.
        if (attributes_.returnNumber) to.returnNumber.push_back(byteOf(rows, E57Role::returnIndex, i, 1));
        if (attributes_.returnCount) to.returnCount.push_back(byteOf(rows, E57Role::returnCount, i, 0));
    }

    static std::uint8_t byteOf(const E57Rows& rows, E57Role role, std::size_t i, double plus) {
        return rows.has(role) ? rows.whole<std::uint8_t>(role, i, plus) : std::uint8_t{0};
    }

    const E57Pages& pages_;
    E57Document& document_;
    const ReadOptions& options_;
    std::string& damage_;
    ReadJob& job_;
    bool drawnOnly_;
    Attributes attributes_;
    PointCloudBuilder builder_;
    std::uint64_t total_ = 0, done_ = 0, met_ = 0;
    std::size_t invalid_ = 0, notFinite_ = 0;
    double leastReturn_ = 0;
    bool returnIsCount_ = false;
};

}  // namespace

PointCloud readE57Points(const E57Pages& pages, E57Document& document, const ReadOptions& options,
                         std::string& damage, ReadJob& job) {
    return Reader(pages, document, options, damage, job).read();
}

std::vector<std::string> e57Attributes(const E57Document& document) {
    const Attributes found(document);
    std::vector<std::string> names;
    const auto name = [&](bool present, const char* text) {
        if (present) names.emplace_back(text);
    };
    name(found.intensity, "intensity");
    name(found.color, "color");
    name(found.classification, "classification");
    name(found.time, "gps_time");
    name(found.normal, "normals");
    name(found.source, "point_source");
    name(found.returnNumber, "return_number");
    name(found.returnCount, "return_count");
    return names;
}

}  // namespace vestige
