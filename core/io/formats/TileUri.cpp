#include "core/io/formats/TileUri.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "core/io/formats/FolderUri.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

bool isAddress(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return uri.starts_with("//");
    return std::isalpha(static_cast<unsigned char>(uri[0])) != 0 &&
           std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [](unsigned char c) {
               return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
           });
}

}  // namespace

fs::path resolveTileUri(std::string_view uri, const fs::path& folder, const fs::path& root,
                        const ReadJob& job) {
    const std::string quoted = "'" + std::string(uri.substr(0, 200)) + "'";
    const std::string within = "files within " + root.string();
    if (isAddress(uri)) job.refuse("the tile " + quoted + " is not a file beside it", within);
    std::string name = percentDecoded(uri.substr(0, uri.find_first_of("?#")));
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.empty() || name.find('\0') != std::string::npos)
        job.refuse("the tile " + quoted + " has no file name", within);
    if (name[0] == '/') job.refuse("the tile " + quoted + " has an absolute path", within);
    std::error_code problem;
    const fs::path file = fs::weakly_canonical(folder / name, problem);
    if (problem) job.refuse("the tile " + quoted + " cannot be found: " + problem.message(), within);
    if (!isInside(file, root)) job.refuse("the tile " + quoted + " lies outside the folder", within);
    if (!fs::exists(file, problem)) job.refuse("the tile " + quoted + " is missing", file.string());
    if (!fs::is_regular_file(file, problem))
        job.refuse("the tile " + quoted + " is no file", "a file, not a folder or device");
    return file;
}

}  // namespace vestige
