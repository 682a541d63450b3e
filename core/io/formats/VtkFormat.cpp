#include "core/io/formats/VtkFormat.h"

#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/VtkFile.h"

namespace vestige {

bool VtkFormat::recognises(std::span<const std::byte> head, std::string_view) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return text.starts_with("# vtk DataFile Version");
}

Result<LoadedGeometry> VtkFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> mapped = MappedFile::open(file);
        if (!mapped) return fail(mapped.error());
        ReadJob job(file, control, options.salvage);
        VtkContent content = readVtk(mapped->text(), job);
        return loaded(std::move(content.mesh), "VTK", content.version, job);
    });
}

}  // namespace vestige
