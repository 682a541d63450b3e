#include "core/pipeline/OutputFolder.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace vestige {
namespace {

namespace fs = std::filesystem;

struct Move {
    fs::path from;
    fs::path to;
};

/// Renames one after the other and remembers how to take it back.
class Moves {
  public:
    std::error_code make(const fs::path& from, const fs::path& to) {
        std::error_code error;
        fs::create_directories(to.parent_path(), error);
        if (!error) fs::rename(from, to, error);
        if (!error) done_.push_back({from, to});
        return error;
    }
    void takeBack() {
        std::error_code ignored;
        for (auto move = done_.rbegin(); move != done_.rend(); ++move)
            fs::rename(move->to, move->from, ignored);
        done_.clear();
    }

  private:
    std::vector<Move> done_;
};

}  // namespace

OutputFolder::OutputFolder(fs::path place) : place_(fs::absolute(std::move(place)).lexically_normal()) {
    if (!place_.has_filename()) place_ = place_.parent_path();
    temporary_ =
        place_.parent_path() / ("." + place_.filename().string() + ".part-" + std::to_string(::getpid()));
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
    std::error_code error;
    for (fs::recursive_directory_iterator entry(temporary_, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->is_regular_file())
            names.push_back(entry->path().lexically_relative(temporary_).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

Status OutputFolder::commit(const std::vector<std::string>& obsolete) {
    const auto names = files();
    const fs::path old = temporary_ / ".old";
    const bool fresh = !fs::exists(place_);
    Moves moves;
    const auto failed = [&](const std::string& name, const std::error_code& error) {
        moves.takeBack();
        std::error_code ignored;
        if (fresh) fs::remove_all(place_, ignored);
        return fail(ErrorCode::output, "the file cannot be put in place: " + error.message(),
                    (place_ / name).string());
    };
    std::vector<std::string> leaving = obsolete;
    leaving.insert(leaving.end(), names.begin(), names.end());
    for (const auto& name : leaving) {
        if (!fs::exists(place_ / name)) continue;
        if (fs::is_directory(place_ / name))
            return failed(name, std::make_error_code(std::errc::is_a_directory));
        if (const auto error = moves.make(place_ / name, old / name)) return failed(name, error);
    }
    for (const auto& name : names)
        if (const auto error = moves.make(temporary_ / name, place_ / name)) return failed(name, error);
    return {};
}

}  // namespace vestige
