#include "core/io/formats/PtxFormat.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/Numbers.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/PtxHeader.h"
#include "core/io/formats/TextLayout.h"

namespace vestige {
namespace {

constexpr std::size_t kMostScans = std::numeric_limits<std::uint16_t>::max();
/// Transforms are written with some six digits.
constexpr double kRigidTolerance = 1e-4;
constexpr std::size_t kMostValues = 7;  // x y z i r g b

bool hasIntensity(std::size_t values) {
    return values == 4 || values == 7;
}
bool hasColor(std::size_t values) {
    return values >= 6;
}

class PtxReader {
  public:
    PtxReader(std::string_view text, ReadJob& job) : scanner_(text), textSize_(text.size()), job_(job) {}

    LoadedGeometry read() {
        job_.untilDamage(
            [&] {
                while (!atEnd()) readScan();
            },
            [&] {
                return WholePart{builder_.size(), "the first " + counted(builder_.size(), "point")};
            });
        if (scans_.empty()) job_.refuseLine(scanner_.line(), "the file has no scan", "a PTX header");
        if (missing_ > 0) job_.warn(counted(missing_, "point") + " without a return left out");
        if (longRows_ > 0)
            job_.warn(counted(longRows_, "row") + " with more values than x y z i r g b, the rest not kept");
        return finish();
    }

  private:
    bool atEnd() {
        TextScanner ahead = scanner_;
        while (!ahead.atEnd())
            if (!trimmed(ahead.nextLine()).empty()) return false;
        return true;
    }

    void readScan() {
        line_ = scanner_.line();
        if (scans_.size() == kMostScans)
            job_.refuseLine(line_, "the file has more scans than can be told apart",
                            std::to_string(kMostScans) + " scans at most");
        const PtxHeader header = readPtxHeader(scanner_, textSize_, job_.salvages(), job_);
        ScanInfo& scan = scans_.emplace_back();
        scan.name = "scan " + std::to_string(scans_.size());
        scan.fileFromScan = poseOf(header, scan.name);
        if (grids_.size() < 60)
            grids_ += (grids_.empty() ? "" : ", ") + std::to_string(header.columns) + " x " +
                      std::to_string(header.rows);
        else if (!grids_.ends_with("..."))
            grids_ += " ...";
        const auto before = static_cast<std::uint16_t>(scans_.size() - 1);
        if (before > 0) builder_.attributes().pointSource.resize(builder_.size(), before);
        readRows(header, scan);
    }

    void readRows(const PtxHeader& header, ScanInfo& scan) {
        std::size_t values = 0;  // of a row of this scan
        for (std::uint64_t i = 0; i < header.points(); ++i) {
            line_ = scanner_.line();
            if ((i & 0xffff) == 0) job_.report(scanner_.offset(), textSize_);
            if (scanner_.atEnd())
                job_.refuseLine(line_,
                                "the file ends after " + counted(static_cast<std::size_t>(i), "point") +
                                    " of " + scan.name,
                                std::to_string(header.points()) + " points as its header says");
            std::size_t bad = 0;
            const std::size_t cells = splitNumbers(scanner_.nextLine(), ' ', row_, bad);
            if (bad > 0 && bad <= kMostValues)
                job_.refuseLine(line_, "value " + std::to_string(bad) + " is no number", "x y z i [r g b]");
            if (cells >= 3 && row_[0] == 0 && row_[1] == 0 && row_[2] == 0) {
                ++missing_;
                continue;
            }
            if (values == 0) values = std::min(cells, kMostValues);
            if (values < 3 || values == 5 || std::min(cells, kMostValues) != values)
                job_.refuseLine(line_, "the row has " + counted(cells, "value"),
                                values < 3 || values == 5
                                    ? "x y z i [r g b]"
                                    : counted(values, "number") + " as in the rows above");
            if (cells > kMostValues) ++longRows_;
            const Eigen::Vector3d point =
                header.linear * Eigen::Vector3d(row_[0], row_[1], row_[2]) + header.shift;
            if (!point.allFinite())
                job_.refuseLine(line_, "a coordinate is no finite number", "finite coordinates");
            add(point, values);
            ++scan.points;
        }
    }

    void add(const Eigen::Vector3d& point, std::size_t values) {
        PointAttributes& attributes = builder_.attributes();
        // Scans before this one that had none of it are filled up.
        if (hasIntensity(values)) {
            if (attributes.intensity.size() < builder_.size()) attributes.intensity.resize(builder_.size());
            attributes.intensity.push_back(toFloat(row_[3]));
        }
        if (hasColor(values)) {
            if (attributes.color.size() < builder_.size()) attributes.color.resize(builder_.size());
            const double* color = row_.data() + values - 3;
            attributes.color.push_back({channel(color[0]), channel(color[1]), channel(color[2])});
        }
        builder_.add(point);
    }

    static std::uint16_t channel(double value) {
        if (!(value > 0)) return 0;
        return static_cast<std::uint16_t>(257 * static_cast<int>(std::nearbyint(std::min(value, 255.0))));
    }

    Pose poseOf(const PtxHeader& header, const std::string& scan) {
        const Eigen::Matrix3d gram = header.linear.transpose() * header.linear;
        const bool rigid = (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRigidTolerance &&
                           header.linear.determinant() > 0;
        if (!rigid)
            job_.warn("the transform of " + scan +
                      " scales, shears or mirrors; its points are as it says, its pose is the nearest one");
        const double apart = (header.scanner - header.shift).norm();
        if (apart > 1e-3 * std::max(1.0, 1e-3 * header.shift.norm()))
            job_.warn("the scanner's place of " + scan + " is " + fixedText(apart, 3) +
                      " from where its transform puts it; the transform counts");
        Pose pose = Pose::Identity();
        pose.linear() = nearestRotation(header.linear);
        pose.translation() = header.shift;
        return pose;
    }

    LoadedGeometry finish() {
        PointAttributes& attributes = builder_.attributes();
        if (!attributes.intensity.empty()) attributes.intensity.resize(builder_.size());
        if (!attributes.color.empty()) attributes.color.resize(builder_.size());
        if (scans_.size() > 1 && builder_.size() > 0)
            attributes.pointSource.resize(builder_.size(), static_cast<std::uint16_t>(scans_.size()));
        LoadedGeometry result = loaded({std::move(builder_).build(), {}}, "PTX",
                                       counted(scans_.size(), "scan") + ", " + grids_, job_);
        result.info.scans = std::move(scans_);
        return result;
    }

    TextScanner scanner_;
    std::size_t textSize_;
    ReadJob& job_;
    PointCloudBuilder builder_;
    std::vector<ScanInfo> scans_;
    std::vector<double> row_ = std::vector<double>(kMostValues);
    std::string grids_;
    std::size_t missing_ = 0, longRows_ = 0, line_ = 1;
};

}  // namespace

bool PtxFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    return looksLikePtx({reinterpret_cast<const char*>(head.data()), head.size()});
}

Result<FileInfo> PtxFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        TextScanner scanner(content->text());
        const PtxHeader header = readPtxHeader(scanner, content->text().size(), true, job);
        FileInfo info;
        info.path = file;
        info.format = "PTX";
        info.version = "first scan " + std::to_string(header.columns) + " x " + std::to_string(header.rows);
        return info;
    });
}

Result<LoadedGeometry> PtxFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        return PtxReader(content->text(), job).read();
    });
}

}  // namespace vestige
