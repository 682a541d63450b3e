#include "core/io/LasWriter.h"

#include <algorithm>
#include <cctype>

#include "core/io/WriteJob.h"
#include "core/io/formats/LasEncode.h"
#include "core/io/formats/LazWriter.h"

namespace vestige {
namespace {

constexpr std::size_t kLargestRecord = 65535;

class LasFileWriter {
  public:
    LasFileWriter(const std::vector<LasPart>& parts, const LasWriteOptions& options,
                  const JobControl& control)
        : parts_(parts), options_(options), control_(control) {
        BoundingBox bounds;
        for (const LasPart& part : parts) {
            plan_.colored = plan_.colored || !part.cloud->attributes().color.empty();
            total_ += part.cloud->size();
            for (std::size_t i = 0; i < part.cloud->size(); ++i) bounds.add(world(part, i));
        }
        grid_ = chooseGrid(options, bounds);
    }

    void write(AtomicFile& file, bool compressed) {
        plan_.compressed = compressed;
        std::unique_ptr<LazWriter> laz = compressed ? std::make_unique<LazWriter>(plan_.colored) : nullptr;
        // The header comes last, when everything is counted; until then its place is held.
        file.write(std::vector<std::byte>(kLasHeaderSize));
        writeRecords(file, laz.get());
        plan_.pointOffset = static_cast<std::size_t>(file.stream().tellp());
        try {
            if (laz) laz->open(file.stream());
            for (const LasPart& part : parts_) writePart(file, part, laz.get());
            if (laz) laz->close();
        } catch (const ErrorException&) {
            // LASzip does not know why a stream takes no more; the file's own sentence does.
            if (file.stream().good()) throw;
            return;
        }
        writeExtendedRecords(file);
        file.stream().seekp(0);
        file.write(encodeHeader(options_, plan_, grid_, totals_));
    }

  private:
    static Eigen::Vector3d world(const LasPart& part, std::size_t i) {
        const Eigen::Vector3d point = part.cloud->point(i);
        return part.worldFromCloud.isIdentity() ? point : part.worldFromCloud * point;
    }

    std::vector<const CrsRecord*> records(bool extended) const {
        std::vector<const CrsRecord*> chosen;
        for (const auto* list : {&options_.crsRecords, &options_.extraRecords})
            for (const CrsRecord& record : *list)
                if ((record.bytes.size() > kLargestRecord) == extended) chosen.push_back(&record);
        return chosen;
    }

    void writeRecords(AtomicFile& file, LazWriter* laz) {
        for (const CrsRecord* record : records(false)) {
            file.write(encodeRecord(*record));
            ++plan_.records;
        }
        if (!laz) return;
        file.write(laz->record());
        ++plan_.records;
    }

    void writeExtendedRecords(AtomicFile& file) {
        file.stream().seekp(0, std::ios::end);
        plan_.extendedOffset = static_cast<std::uint64_t>(file.stream().tellp());
        for (const CrsRecord* record : records(true)) {
            file.write(encodeExtendedRecord(*record));
            ++plan_.extendedRecords;
        }
    }

    void writePart(AtomicFile& file, const LasPart& part, LazWriter* laz) {
        if (!part.complete) return writePoints(file, part, laz);
        const double written =
            total_ > 0 ? static_cast<double>(totals_.points) / static_cast<double>(total_) : 0;
        const auto cloud = part.complete(control_.sub(written, written));
        if (!cloud) throw ErrorException(cloud.error());
        LasPart whole = part;
        whole.cloud = cloud->get();
        writePoints(file, whole, laz);
    }

    void writePoints(AtomicFile& file, const LasPart& part, LazWriter* laz) {
        constexpr std::byte kWithheld{4};  // bit 2 of the classification flags, LAS 1.4 table 18
        std::span<const PointSet::Run> withheld;
        if (part.withheld) withheld = part.withheld->runs();
        for (std::size_t i = 0; i < part.cloud->size(); ++i) {
            stepWriting(control_, totals_.points, total_);
            const std::array<std::int32_t, 3> integers = grid_.integers(world(part, i));
            std::vector<std::byte> record =
                encodePoint(part, i, integers, plan_.colored, options_.keepPointSource);
            while (!withheld.empty() && withheld.front().second <= i) withheld = withheld.subspan(1);
            if (!withheld.empty() && withheld.front().first <= i) record[15] |= kWithheld;
            if (laz)
                laz->add(record);
            else
                file.write(record);
            totals_.bounds.add(grid_.coordinates(integers));
            ++totals_.points;
            const auto returnNumber = std::to_integer<std::size_t>(record[14]) & 15;
            if (returnNumber > 0) ++totals_.byReturn[returnNumber - 1];
        }
    }

    const std::vector<LasPart>& parts_;
    const LasWriteOptions& options_;
    const JobControl& control_;
    LasPlan plan_;
    LasGrid grid_;
    LasTotals totals_;
    std::uint64_t total_ = 0;
};

bool namesLaz(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".laz";
}

}  // namespace

Status writeLas(const std::filesystem::path& file, const std::vector<LasPart>& parts,
                const LasWriteOptions& options, const JobControl& control) {
    return writeAtomically(file, [&](AtomicFile& target) {
        LasFileWriter(parts, options, control).write(target, namesLaz(file));
    });
}

}  // namespace vestige
