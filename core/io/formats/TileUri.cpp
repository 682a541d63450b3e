#include "core/io/formats/TileUri.h"

#include <algorithm>
#include <cctype>
#include <string>

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

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string percentDecoded(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
        decoded += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
        if (low >= 0) i += 2;
    }
    return decoded;
}

bool isInside(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
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
