#include "core/base/OutputFolder.h"

#include <algorithm>
#include <utility>

#include "core/base/AtomicFile.h"
#include "core/base/Durable.h"
#include "core/base/FileReplacements.h"
#include "core/base/FolderExchange.h"
#include "core/base/HiddenName.h"
#include "core/base/Leftovers.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// Both inside the temporary folder; no output is called so.
constexpr const char* kPlan = ".plan";
constexpr const char* kOld = ".old";
/// Lists the others with their hashes. While others are moved one by one it is away, so that a folder without
/// it is known to be unfinished.
constexpr const char* kSeal = "manifest.json";

std::string prefixOf(const fs::path& place) {
    const HiddenName name = hiddenNameOf(place);
    return name.stem + name.extension + ".part-";
}

std::vector<std::string> filesBelow(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error, unknown;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const auto name = entry->path().filename();
        if (name == kOld && entry.depth() == 0) entry.disable_recursion_pending();
        if (entry->is_regular_file(unknown) && name != kPlan)
            names.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Status failed(const fs::path& file, const std::error_code& error) {
    return fail(ErrorCode::output, "the file cannot be put in place: " + error.message(), file.string());
}

/// Moves what lies in `ready` to `place`, file by file, all or none.
Status moveFiles(const fs::path& ready, const fs::path& place, std::vector<std::string> cleared) {
    auto names = filesBelow(ready);
    const fs::path old = ready / kOld;
    const auto seal = std::find(names.begin(), names.end(), kSeal);
    if (seal != names.end()) {
        std::rotate(seal, seal + 1, names.end());
        cleared.insert(cleared.begin(), kSeal);
    }
    FileReplacements moves;
    for (const auto& name : cleared)
        if (const auto error = moves.remove(place / name, old / name)) return failed(place / name, error);
    for (const auto& name : names)
        if (const auto error = moves.replace(ready / name, place / name, old / name))
            return failed(place / name, error);
    moves.keep();
    syncFolder(place);
    return {};
}

/// The names to clear, each ended by a zero byte.
std::string planText(const std::vector<std::string>& cleared) {
    std::string text;
    for (const auto& name : cleared) text += name + '\0';
    return text;
}

std::vector<std::string> readPlan(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\0', begin), text.size());
        const fs::path name = text.substr(begin, end - begin);
        const bool inside = name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end();
        if (inside) names.push_back(name.string());
        begin = end + 1;
    }
    return names;
}

/// Finishes what a killed process had begun to move, and clears away what it had not.
void finishEarlier(const fs::path& place) {
    for (const auto& ready : leftovers(place.parent_path(), prefixOf(place), "")) {
        std::error_code ignored;
        if (const auto plan = readTextFile(ready / kPlan); plan && fs::is_directory(place, ignored))
            static_cast<void>(moveFiles(ready, place, readPlan(*plan)));
        fs::remove_all(ready, ignored);
    }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& place) : place_(fs::absolute(place).lexically_normal()) {
    if (!place_.has_filename()) place_ = place_.parent_path();
    temporary_ = place_.parent_path() / (prefixOf(place_) + ownerMark());
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    fs::remove(temporary_ / kPlan, ignored);
    fs::remove_all(temporary_, ignored);
}

Status OutputFolder::open() {
    std::error_code error;
    if (fs::exists(place_, error) && !fs::is_directory(place_, error))
        return fail(ErrorCode::output, "the output folder cannot be made: a file of this name exists",
                    place_.string());
    finishEarlier(place_);
    fs::remove_all(temporary_, error);
    fs::create_directories(temporary_, error);
    if (error)
        return fail(ErrorCode::output, "the folder cannot be made: " + error.message(), place_.string());
    return {};
}

fs::path OutputFolder::path(const std::string& name) {
    const fs::path file = temporary_ / name;
    std::error_code ignored;  // a folder that cannot be made shows when the file is written
    fs::create_directories(file.parent_path(), ignored);
    return file;
}

std::vector<std::string> OutputFolder::files() const {
    return filesBelow(temporary_);
}

Status OutputFolder::commit(const std::vector<std::string>& obsolete) {
    const auto names = files();
    for (const auto& name : names)
        if (const auto error = syncFile(temporary_ / name)) return failed(place_ / name, error);
    std::error_code unknown;
    const bool fresh = !fs::exists(fs::symlink_status(place_, unknown));
    if (fresh && renameFolder(temporary_, place_)) return {};
    std::vector<std::string> known = names;
    std::vector<std::string> cleared;
    for (const auto& name : obsolete) {
        known.push_back(name);
        if (!std::binary_search(names.begin(), names.end(), name)) cleared.push_back(name);
    }
    if (!fresh && exchangeFolders(temporary_, place_, known)) return {};
    if (const Status planned = writeTextFile(temporary_ / kPlan, planText(cleared)); !planned) return planned;
    Status done = moveFiles(temporary_, place_, cleared);
    if (!done && fresh) fs::remove_all(place_, unknown);
    return done;
}

}  // namespace vestige
