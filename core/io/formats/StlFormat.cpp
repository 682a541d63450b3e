#include "core/io/formats/StlFormat.h"

#include <algorithm>
#include <array>

#include "core/io/Bytes.h"
#include "core/io/Coordinates.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/TextScanner.h"
#include "core/io/formats/VertexWelder.h"

namespace vestige {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

using Corners = std::array<Eigen::Vector3d, 3>;

/// A facet at a time, so that none is left half where a file is damaged.
void add(const Corners& corners, VertexWelder& welder) {
    for (const Eigen::Vector3d& corner : corners) welder.add(corner);
}

Eigen::Vector3d vertexOf(std::string_view line, std::size_t number, const ReadJob& job) {
    Eigen::Vector3d vertex;
    TextScanner numbers(line);
    for (double& coordinate : vertex) {
        const auto value = numbers.nextNumber();
        if (!value) job.refuseLine(number, "a coordinate is missing or no number", "vertex x y z");
        coordinate = *value;
    }
    if (!isUsable(vertex))
        job.refuseLine(number, std::string(kUnusableCoordinate), std::string(kUsableCoordinates));
    return vertex;
}

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
    if (file.size() - kHeader > kFacet * std::size_t{facets})
        job.warn("the file goes on behind its last facet");
    const std::size_t there = std::min<std::size_t>(facets, (file.size() - kHeader) / kFacet);
    VertexWelder welder(job);
    const auto readAll = [&] {
        for (std::size_t i = 0; i < there; ++i) {
            job.step(i, facets);
            Corners corners;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::byte* at = file.data() + kHeader + kFacet * i + 12 + 12 * corner;
                corners[corner] = {load<float>(at), load<float>(at + 4), load<float>(at + 8)};
                if (!isUsable(corners[corner]))
                    job.refuseByte(static_cast<std::size_t>(at - file.data()),
                                   std::string(kUnusableCoordinate), std::string(kUsableCoordinates));
            }
            add(corners, welder);
        }
        if (there < facets)
            job.refuseByte(
                80, "the file promises " + counted(facets, "facet") + ", but it ends too early for them",
                "50 bytes for each, " + std::to_string(file.size() - kHeader) + " are left");
    };
    job.untilDamage(readAll, [&] {
        return WholePart{welder.corners(), firstOf(welder.corners() / 3, facets, "facet")};
    });
    return std::move(welder).build();
}

/// Only the lines "vertex x y z" count; three make a facet.
void readFacets(std::string_view text, const ReadJob& job, VertexWelder& welder) {
    TextScanner scanner(text);
    std::string_view first = scanner.nextLine();
    if (!equalsIgnoringCase(takeToken(first), "solid"))
        job.refuseLine(1, "this is neither a binary nor a text STL file",
                       "a line 'solid', or 84 bytes of header");
    std::size_t lastLine = 1;
    bool ended = false;
    Corners corners;
    std::size_t met = 0;
    while (!scanner.atEnd()) {
        lastLine = scanner.line();
        if ((lastLine & 0xffff) == 0) job.report(scanner.offset(), text.size());
        std::string_view line = scanner.nextLine();
        const std::string_view keyword = takeToken(line);
        ended = ended || equalsIgnoringCase(keyword, "endsolid");
        if (equalsIgnoringCase(keyword, "endfacet") && met != 0)
            job.refuseLine(lastLine, "a facet ends without three vertices", "three lines 'vertex x y z'");
        if (!equalsIgnoringCase(keyword, "vertex")) continue;
        corners[met] = vertexOf(line, lastLine, job);
        if (++met < corners.size()) continue;
        add(corners, welder);
        met = 0;
    }
    if (met != 0 || !ended) job.refuseLine(lastLine, "the file ends inside its mesh", "a line 'endsolid'");
}

TriangleMesh readText(std::string_view text, ReadJob& job) {
    VertexWelder welder(job);
    job.untilDamage([&] { readFacets(text, job, welder); },
                    [&] {
                        const std::string facets = counted(welder.corners() / 3, "facet");
                        return WholePart{welder.corners(), "the first " + facets};
                    });
    return std::move(welder).build();
}

}  // namespace

bool StlFormat::recognises(std::span<const std::byte> head, std::string_view extension) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return extension == "stl" || (text.starts_with("solid") && text.find("facet") != std::string_view::npos);
}

Result<LoadedGeometry> StlFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        const bool binary = isBinary(content->bytes());
        TriangleMesh mesh = binary ? readBinary(content->bytes(), job) : readText(content->text(), job);
        return loaded(std::move(mesh), "STL", binary ? "binary" : "ascii", job);
    });
}

}  // namespace vestige
