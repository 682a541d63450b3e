#include "core/scene/CaseFile.h"

#include "core/base/AtomicFile.h"
#include "core/base/Hash.h"
#include "core/io/LooksLikeTileset.h"
#include "core/scene/casefile/CaseText.h"
#include "core/scene/store/CaseStore.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

std::string stemOfCase(const fs::path& file) {
    const fs::path absolute = fs::absolute(file).lexically_normal();
    const fs::path named = absolute.has_filename() ? absolute : absolute.parent_path();
    return named.filename() == "case.json" ? named.parent_path().stem().string() : named.stem().string();
}

fs::path folderOf(const fs::path& json) {
    return fs::absolute(json).lexically_normal().parent_path();
}

Result<std::string> readJson(const fs::path& json) {
    auto text = guarded(json.string(), [&] { return readTextFile(json, kLargestCaseText); });
    return text;
}

/// The saved case of a store, with a warning of what it does not hold.
Result<std::string> readStore(const fs::path& folder, std::vector<std::string>* warnings,
                              UnsavedEdits unsaved) {
    auto stored = readCaseStore(folder);
    if (!stored) return fail(stored.error());
    std::error_code unknown;
    if (!stored->saved && fs::exists(folder / "case.db", unknown) &&
        !fs::exists(folder / "case.json", unknown))
        return fail(ErrorCode::input, "nothing has been saved here yet", folder.string(),
                    "edits that were made before are offered when the program starts");
    if (!stored->saved) return readJson(folder / "case.json");
    if (warnings && stored->unsaved > 0 && unsaved == UnsavedEdits::told)
        warnings->push_back(folder.string() + ": " + stored->unsavedSentence() +
                            "; the case as it was saved is used");
    if (warnings && stored->copyChanged)
        warnings->push_back((folder / "case.json").string() +
                            ": this copy was changed by another program and is not read; the case is what "
                            "case.db holds");
    return std::move(*stored->saved);
}

}  // namespace

bool isCaseStore(const fs::path& path) {
    const fs::path named = path.has_filename() ? path : path.parent_path();
    std::error_code ignored;
    return named.extension() == ".vestige" && !fs::is_regular_file(named, ignored);
}

fs::path caseJsonPath(const fs::path& path) {
    std::error_code ignored;
    return isCaseStore(path) || fs::is_directory(path, ignored) ? path / "case.json" : path;
}

fs::path casePlace(const fs::path& path) {
    fs::path place = fs::absolute(path).lexically_normal();
    if (!place.has_filename()) place = place.parent_path();
    std::error_code ignored;
    // Whoever picks the readable copy inside a store means the case.
    if (place.filename() == "case.json" && isCaseStore(place.parent_path()) &&
        fs::exists(place.parent_path() / "case.db", ignored))
        return place.parent_path();
    if (!isCaseStore(place)) place = caseJsonPath(place);
    const fs::path whole = fs::weakly_canonical(place, ignored);
    return ignored ? place : whole;
}

bool looksLikeCase(const fs::path& path) {
    std::string extension = path.extension().string();
    if (!path.has_filename()) extension = path.parent_path().extension().string();
    std::error_code ignored;
    return extension == ".vestige" || (extension == ".json" && !looksLikeTileset(path)) ||
           fs::is_regular_file(path / "case.json", ignored);
}

Result<SceneState> readCase(const fs::path& file, std::vector<std::string>* warnings, UnsavedEdits unsaved) {
    const fs::path place = casePlace(file);
    const fs::path json = isCaseStore(place) ? caseJsonPath(place) : caseJsonPath(file);
    const auto text = isCaseStore(place) ? readStore(place, warnings, unsaved) : readJson(json);
    if (!text) return fail(text.error());
    auto scene = sceneFromText(*text, json.string(), folderOf(json), warnings);
    if (!scene) return scene;
    scene->file = file;
    if (scene->name.empty()) scene->name = stemOfCase(file);
    return scene;
}

Status writeCase(const fs::path& file, const SceneState& scene) {
    const fs::path place = casePlace(file);
    if (isCaseStore(place)) {
        auto store = CaseStore::open(place);
        if (!store) return fail(store.error());
        return (*store)->save(scene);
    }
    const fs::path json = caseJsonPath(file);
    const Result<std::string> text = textInFolder(scene, folderOf(json));
    if (!text) return fail(text.error());
    return writeTextFile(json, *text);
}

Result<std::pair<fs::path, std::string>> caseContent(const fs::path& file) {
    const fs::path place = casePlace(file);
    const fs::path json = caseJsonPath(isCaseStore(place) ? place : file);
    if (isCaseStore(place)) {
        const auto stored = readCaseStore(place);
        if (!stored) return fail(stored.error());
        if (stored->saved) {
            Sha256 sha;
            sha.add(*stored->saved);
            const std::string hash = sha.hex();
            const auto copy = sha256OfFile(json);
            return std::pair(copy && *copy == hash ? json : place / "case.db", hash);
        }
    }
    const auto hash = sha256OfFile(json);
    if (!hash) return fail(hash.error());
    return std::pair(json, *hash);
}

}  // namespace vestige
