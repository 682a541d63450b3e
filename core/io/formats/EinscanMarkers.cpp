#include "core/io/formats/EinscanMarkers.h"

namespace vestige {
namespace {

tl::unexpected<Error> advice(const std::filesystem::path& file) {
    return fail(ErrorCode::input,
                "this is an EinScan marker file (P3), whose layout its maker has not published",
                file.string(),
                "export the scan from EXScan as ASC, PLY, OBJ or STL, and the markers as text with x y z on "
                "each line");
}

}  // namespace

bool EinscanMarkers::recognises(std::span<const std::byte>, std::string_view) const {
    return false;  // whatever another format knows by its content is that, also under this extension
}

Result<FileInfo> EinscanMarkers::peek(const std::filesystem::path& file, const JobControl&) const {
    return advice(file);
}

Result<LoadedGeometry> EinscanMarkers::read(const std::filesystem::path& file, const ReadOptions&,
                                            const JobControl&) const {
    return advice(file);
}

}  // namespace vestige
