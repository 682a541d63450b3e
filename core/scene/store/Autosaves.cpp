#include "core/scene/store/Autosaves.h"

#include <algorithm>

#include "core/base/Leftovers.h"
#include "core/scene/CaseFile.h"

namespace vestige {

namespace fs = std::filesystem;

Result<std::unique_ptr<CaseStore>> Autosaves::create(const fs::path& place) const {
    std::error_code unknown;
    fs::path folder;
    for (int number = 1; folder.empty() || fs::exists(folder, unknown); ++number)
        folder = root_ / (ownerMark() + "-" + std::to_string(number) + ".vestige");
    auto store = CaseStore::open(folder);
    if (!store) {
        remove(folder);
        return store;
    }
    if (const Status told = (*store)->setCaseFile(place); !told) return fail(told.error());
    return store;
}

std::vector<Abandoned> Autosaves::abandoned() const {
    std::vector<Abandoned> found;
    std::error_code error;
    for (fs::directory_iterator entry(root_, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path folder = entry->path();
        if (!isCaseStore(folder)) continue;
        CaseLock::Refusal refusal;
        const auto lock = CaseLock::take(CaseLock::fileFor(folder), refusal);
        if (!lock) continue;
        auto content = readCaseStore(folder);
        // A damaged one is left for whoever can make something of it.
        if (!content) continue;
        if (content->drafts.empty())
            remove(folder);
        else
            found.push_back({folder, std::move(*content)});
    }
    std::sort(found.begin(), found.end(), [](const Abandoned& a, const Abandoned& b) {
        return a.content.lastMoment > b.content.lastMoment;
    });
    return found;
}

std::optional<Abandoned> Autosaves::abandonedOf(const fs::path& place) const {
    for (auto& one : abandoned())
        if (one.content.caseFile == place.string()) return std::move(one);
    return std::nullopt;
}

void Autosaves::remove(const fs::path& folder) {
    std::error_code ignored;
    // The lock last: a store without its database is nothing, one without its lock would be taken for free.
    for (const char* name : {"case.db", "case.db-journal", "case.json"}) fs::remove(folder / name, ignored);
    fs::remove_all(folder, ignored);
}

}  // namespace vestige
