#include "core/evaluation/SequenceFiles.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "core/base/Numbers.h"
#include "core/io/FormatRegistry.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

std::string extensionOf(const fs::path& file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool isReadable(const std::string& extension) {
    for (const auto& format : fileFormats())
        for (const std::string& one : format->extensions())
            if (one == extension) return true;
    return false;
}

/// ASL clouds: `begin`, a number, ".csv".
void takeNumbered(const std::vector<fs::path>& files, const std::string& begin, SequenceFiles& sequence) {
    for (const fs::path& file : files) {
        const std::string stem = file.stem().string();
        if (!stem.starts_with(begin) || extensionOf(file) != "csv") continue;
        const auto id = parseInteger(std::string_view(stem).substr(begin.size()));
        if (!id || !isDigit(stem[begin.size()])) continue;
        sequence.clouds.push_back(file);
        sequence.ids.push_back(*id);
    }
}

void takeMostFrequent(const std::vector<fs::path>& files, SequenceFiles& sequence) {
    std::map<std::string, std::vector<fs::path>> byExtension;
    for (const fs::path& file : files)
        if (const std::string extension = extensionOf(file); isReadable(extension))
            byExtension[extension].push_back(file);
    for (const auto& [extension, some] : byExtension)
        if (some.size() > sequence.clouds.size()) sequence.clouds = some;
}

}  // namespace

bool naturallyBefore(const std::string& a, const std::string& b) {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!isDigit(a[i]) || !isDigit(b[j])) {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
            continue;
        }
        while (i < a.size() && a[i] == '0') ++i;
        while (j < b.size() && b[j] == '0') ++j;
        std::size_t m = i, n = j;
        while (m < a.size() && isDigit(a[m])) ++m;
        while (n < b.size() && isDigit(b[n])) ++n;
        if (m - i != n - j) return m - i < n - j;
        if (const int order = a.compare(i, m - i, b, j, n - j); order != 0) return order < 0;
        i = m;
        j = n;
    }
    // "scan01" and "scan1" are the same but for the zeros: some order that depends on the names alone.
    return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

Result<SequenceFiles> sequenceFiles(const fs::path& folder, const fs::path& truth) {
    std::error_code problem;
    std::error_code ignored;
    std::vector<fs::path> files;
    for (auto entry = fs::directory_iterator(folder, problem); !problem && entry != fs::directory_iterator();
         entry.increment(problem))
        if (entry->is_regular_file(ignored) && !fs::equivalent(entry->path(), truth, ignored))
            files.push_back(entry->path());
    if (problem)
        return fail(ErrorCode::input, "the folder cannot be read", folder.string(), problem.message());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturallyBefore(a.filename().string(), b.filename().string());
    });
    SequenceFiles sequence;
    takeNumbered(files, "Hokuyo_", sequence);
    if (sequence.clouds.empty()) {
        takeNumbered(files, "PointCloud", sequence);
        sequence.inWorldFrame = !sequence.clouds.empty();
    }
    if (sequence.clouds.empty()) takeMostFrequent(files, sequence);
    if (sequence.clouds.size() < 2)
        return fail(ErrorCode::input, "there are fewer than two clouds", folder.string(),
                    "expected Hokuyo_N.csv, PointCloudN.csv or clouds of any readable format");
    return sequence;
}

}  // namespace vestige
