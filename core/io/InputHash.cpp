#include "core/io/InputHash.h"

#include <algorithm>
#include <utility>

#include "core/base/Hash.h"

namespace vestige {

Result<InputHash> hashInput(const std::filesystem::path& file, const std::string& ownSha256,
                            const std::vector<std::filesystem::path>& companions, const JobControl& control) {
    InputHash input{ownSha256, {}};
    if (companions.empty()) return input;
    const std::filesystem::path folder = std::filesystem::absolute(file).lexically_normal().parent_path();
    std::vector<std::pair<std::string, std::string>> lines;
    const auto count = static_cast<double>(companions.size());
    for (std::size_t i = 0; i < companions.size(); ++i) {
        auto hash = sha256OfFile(
            companions[i], control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        if (!hash) return fail(hash.error());
        lines.emplace_back(std::filesystem::absolute(companions[i])
                               .lexically_normal()
                               .lexically_relative(folder)
                               .generic_string(),
                           *hash);
        input.companions.push_back(std::move(*hash));
    }
    std::sort(lines.begin(), lines.end());
    Sha256 list;
    list.add(ownSha256 + "  " + file.filename().string() + "\n");
    for (const auto& [name, hash] : lines) list.add(hash + "  " + name + "\n");
    input.sha256 = list.hex();
    return input;
}

Result<InputHash> hashInput(const std::filesystem::path& file,
                            const std::vector<std::filesystem::path>& companions, const JobControl& control) {
    const auto own = sha256OfFile(file, control.sub(0, companions.empty() ? 1 : 0.2));
    if (!own) return fail(own.error());
    return hashInput(file, *own, companions, control.sub(0.2, 1));
}

Status companionsAsRead(const FileInfo& info) {
    for (std::size_t i = 0; i < info.companions.size() && i < info.companionStamps.size(); ++i)
        if (stampOf(info.companions[i]).value_or(FileStamp{}) != info.companionStamps[i])
            return fail(changedWhileRead(info.companions[i], info.companionStamps[i]));
    return {};
}

}  // namespace vestige
