#include "core/base/OutputFolder.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/base/FileReplacements.h"
#include "core/base/HiddenName.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

}  // namespace

OutputFolder::OutputFolder(fs::path place) : place_(fs::absolute(std::move(place)).lexically_normal()) {
    if (!place_.has_filename()) place_ = place_.parent_path();
    const HiddenName name = hiddenNameOf(place_);
    temporary_ = place_.parent_path() / (name.stem + name.extension + ".part-" + std::to_string(::getpid()));
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
}

Status OutputFolder::open() {
    std::error_code error;
    if (fs::exists(place_, error) && !fs::is_directory(place_, error))
        return fail(ErrorCode::output, "the output folder cannot be made: a file of this name exists",
                    place_.string());
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
    std::vector<std::string> names;
    std::error_code error, unknown;
    for (fs::recursive_directory_iterator entry(temporary_, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file(unknown))
            names.push_back(entry->path().lexically_relative(temporary_).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

Status OutputFolder::commit(const std::vector<std::string>& obsolete) {
    const auto names = files();
    const fs::path old = temporary_ / ".old";
    std::error_code unknown;
    const bool fresh = !fs::exists(place_, unknown) && !unknown;
    const auto failed = [&](const std::string& name, const std::error_code& error) {
        return fail(ErrorCode::output, "the file cannot be put in place: " + error.message(),
                    (place_ / name).string());
    };
    Status done;
    {
        FileReplacements moves;
        for (const auto& name : obsolete) {
            if (std::find(names.begin(), names.end(), name) != names.end()) continue;
            if (const auto error = moves.remove(place_ / name, old / name); done && error)
                done = failed(name, error);
        }
        for (const auto& name : names) {
            if (!done) break;
            if (const auto error = moves.replace(temporary_ / name, place_ / name, old / name))
                done = failed(name, error);
        }
        if (done) moves.keep();
    }
    if (!done && fresh) fs::remove_all(place_, unknown);
    return done;
}

}  // namespace vestige
