#include "core/evaluation/SequenceFiles.h"

#include <algorithm>
#include <cctype>

#include "core/io/FormatRegistry.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isReadable(const fs::path& file) {
    std::string extension = file.extension().string();
    if (extension.empty()) return false;
    extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& format : fileFormats())
        for (const std::string& one : format->extensions())
            if (one == extension) return true;
    return false;
}

std::vector<fs::path> named(const std::vector<fs::path>& files, const std::string& begin) {
    std::vector<fs::path> found;
    for (const fs::path& file : files)
        if (file.filename().string().starts_with(begin) && file.extension() == ".csv") found.push_back(file);
    return found;
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
    return a.size() - i < b.size() - j;
}

Result<SequenceFiles> sequenceFiles(const fs::path& folder, const fs::path& truth) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (auto entry = fs::directory_iterator(folder, problem); !problem && entry != fs::directory_iterator();
         entry.increment(problem))
        if (entry->is_regular_file() && !fs::equivalent(entry->path(), truth, problem))
            files.push_back(entry->path());
    if (problem)
        return fail(ErrorCode::input, "the folder cannot be read", folder.string(), problem.message());
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturallyBefore(a.filename().string(), b.filename().string());
    });
    SequenceFiles sequence;
    sequence.clouds = named(files, "Hokuyo_");
    if (sequence.clouds.empty()) {
        sequence.clouds = named(files, "PointCloud");
        sequence.inWorldFrame = !sequence.clouds.empty();
    }
    if (sequence.clouds.empty())
        std::copy_if(files.begin(), files.end(), std::back_inserter(sequence.clouds), isReadable);
    if (sequence.clouds.size() < 2)
        return fail(ErrorCode::input, "there are fewer than two clouds", folder.string(),
                    "expected Hokuyo_N.csv, PointCloudN.csv or clouds of any readable format");
    return sequence;
}

}  // namespace vestige
