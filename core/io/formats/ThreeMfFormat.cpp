#include "core/io/formats/ThreeMfFormat.h"

#include <utility>

#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/ZipDirectory.h"
#include "core/io/importer/ImporterProcess.h"

namespace vestige {
namespace {

/// The shortest text that makes a vertex: <vertex x="0" y="0" z="0"/>.
constexpr std::uint64_t kVertexText = 27;
/// What a mesh or an object that places one sends, against the text that it stands in.
constexpr std::uint64_t kSentPerByte = 8;
/// Objects may stand in a file many times; this is how many vertices a file may always grow to by that, and
/// how often its own ones may be repeated beyond.
constexpr std::uint64_t kVerticesAllowed = 10'000'000;
constexpr std::uint64_t kRepeats = 16;

}  // namespace

bool ThreeMfFormat::recognises(std::span<const std::byte> head, std::string_view extension) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return text.starts_with("PK\3\4") &&
           (extension == "3mf" || text.find("3D/3dmodel.model") != std::string_view::npos);
}

Result<LoadedGeometry> ThreeMfFormat::read(const std::filesystem::path& file, const ReadOptions& /*options*/,
                                           const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        ReadJob job(file, control);
        std::uint64_t inflated = 0;
        ImportRequest request;
        {
            const Result<MappedFile> content = MappedFile::open(file);
            if (!content) return fail(content.error());
            for (const ZipEntry& entry : readZipDirectory(content->bytes(), {}, job)) inflated += entry.size;
            inflated += content->bytes().size();
        }
        request.format = "3mf";
        request.files.push_back(openForReading(file));
        request.memoryBytes = importMemoryFor(inflated);
        request.time = importTimeFor(inflated);
        request.resultBytes = 65536 + kSentPerByte * inflated;
        ImportedScene scene = importScene(std::move(request), job, control);
        const std::optional<double> unit = scene.metresPerUnit;
        const std::uint64_t most = kVerticesAllowed + kRepeats * (inflated / kVertexText);
        LoadedGeometry result = loaded(assembleScene(std::move(scene), most, job), "3MF", "", job);
        result.info.metresPerUnit = unit;
        return result;
    });
}

}  // namespace vestige
