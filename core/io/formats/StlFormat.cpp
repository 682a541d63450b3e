#include "core/io/formats/StlFormat.h"

#include "core/io/Bytes.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/TextScanner.h"
#include "core/io/formats/VertexWelder.h"

namespace vestige {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

/// A binary file holds exactly its facets; "solid" alone proves nothing, for binary files may begin so too.
bool isBinary(std::span<const std::byte> file) {
    if (file.size() < kHeader) return false;
    const auto facets = load<std::uint32_t>(file.data() + 80);
    if (file.size() == kHeader + kFacet * std::size_t{facets}) return true;
    const std::string_view head(reinterpret_cast<const char*>(file.data()), 5);
    return head != "solid";
}

TriangleMesh readBinary(std::span<const std::byte> file, ReadJob& job) {
    const auto facets = load<std::uint32_t>(file.data() + 80);
    if (facets > (file.size() - kHeader) / kFacet)
        job.refuseByte(80,
                       "the file promises " + counted(facets, "facet") + ", but it ends too early for them",
                       "50 bytes for each, " + std::to_string(file.size() - kHeader) + " are left");
    if (file.size() - kHeader > kFacet * std::size_t{facets})
        job.warn("the file goes on behind its last facet");
    VertexWelder welder(job);
    for (std::size_t i = 0; i < facets; ++i) {
        job.step(i, facets);
        const std::byte* facet = file.data() + kHeader + kFacet * i;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::byte* at = facet + 12 + 12 * corner;
            const Eigen::Vector3d vertex(load<float>(at), load<float>(at + 4), load<float>(at + 8));
            if (!vertex.allFinite())
                job.refuseByte(static_cast<std::size_t>(at - file.data()), "a coordinate is no finite number",
                               "finite coordinates");
            welder.add(vertex);
        }
    }
    return std::move(welder).build();
}

/// Only the lines "vertex x y z" count; three make a facet.
TriangleMesh readText(std::string_view text, ReadJob& job) {
    VertexWelder welder(job);
    TextScanner scanner(text);
    std::string_view first = scanner.nextLine();
    if (!equalsIgnoringCase(takeToken(first), "solid"))
        job.refuseLine(1, "this is neither a binary nor a text STL file",
                       "a line 'solid', or 84 bytes of header");
    std::size_t lastLine = 1;
    bool ended = false;
    while (!scanner.atEnd()) {
        lastLine = scanner.line();
        if ((lastLine & 0xffff) == 0) job.report(scanner.offset(), text.size());
        std::string_view line = scanner.nextLine();
        const std::string_view keyword = takeToken(line);
        ended = ended || equalsIgnoringCase(keyword, "endsolid");
        if (equalsIgnoringCase(keyword, "endfacet") && welder.corners() % 3 != 0)
            job.refuseLine(lastLine, "a facet ends without three vertices", "three lines 'vertex x y z'");
        if (!equalsIgnoringCase(keyword, "vertex")) continue;
        Eigen::Vector3d vertex;
        TextScanner numbers(line);
        for (double& coordinate : vertex) {
            const auto number = numbers.nextNumber();
            if (!number || !std::isfinite(*number))
                job.refuseLine(lastLine, "a coordinate is missing or no finite number", "vertex x y z");
            coordinate = *number;
        }
        welder.add(vertex);
    }
    if (welder.corners() % 3 != 0 || !ended)
        job.refuseLine(lastLine, "the file ends inside its mesh", "a line 'endsolid'");
    return std::move(welder).build();
}

}  // namespace

bool StlFormat::recognises(std::span<const std::byte> head, std::string_view extension) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return extension == "stl" || (text.starts_with("solid") && text.find("facet") != std::string_view::npos);
}

Result<LoadedGeometry> StlFormat::read(const std::filesystem::path& file, const ReadOptions& /*options*/,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const bool binary = isBinary(content->bytes());
        TriangleMesh mesh = binary ? readBinary(content->bytes(), job) : readText(content->text(), job);
        return loaded(std::move(mesh), "STL", binary ? "binary" : "ascii", job);
    });
}

}  // namespace vestige
