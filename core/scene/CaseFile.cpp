#include "core/scene/CaseFile.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/AtomicFile.h"
#include "core/base/CleanText.h"
#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

// A case with a thousand measurements is 2 MB and 40 000 values; the limits keep a hostile file from filling
// the memory.
constexpr std::size_t kLargestFile = std::size_t{16} << 20;
constexpr std::size_t kMostValues = 1000000;
constexpr int kDeepest = 64;

/// Refuses a text that would make a tree too deep or too large, before there is any. Knows just enough of
/// JSON to tell brackets and commas from text.
void checkSize(const std::string& text, const std::string& file) {
    std::size_t values = 0;
    int depth = 0;
    bool inText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inText) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inText = false;
            continue;
        }
        inText = c == '"';
        const bool opens = c == '[' || c == '{';
        if (opens) ++depth;
        if (c == ']' || c == '}') --depth;
        if (opens || c == ',') ++values;
        if (depth > kDeepest)
            throw ErrorException{{ErrorCode::input, "the JSON is nested deeper than any case", file, {}}};
        if (values > kMostValues)
            throw ErrorException{{ErrorCode::input, "the JSON holds more values than any case", file, {}}};
    }
}

/// Refuses a key that stands twice in one object: which of the two counts, every reader of JSON decides for
/// itself.
class KeyWatch {
  public:
    explicit KeyWatch(const std::string& file) : file_(file) {}

    bool operator()(int, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
        using enum nlohmann::json::parse_event_t;
        if (event == object_start) seen_.emplace_back();
        if (event == object_end) seen_.pop_back();
        if (event == key && !seen_.back().insert(parsed.get<std::string>()).second)
            throw ErrorException{
                {ErrorCode::input,
                 "the key \"" + cleanText(parsed.get<std::string>()) + "\" stands twice in one object", file_,
                 "expected each key once"}};
        return true;
    }

  private:
    const std::string& file_;
    std::vector<std::set<std::string>> seen_;
};

nlohmann::json parse(const std::string& text, const std::string& file) {
    checkSize(text, file);
    KeyWatch keys(file);
    try {
        return nlohmann::json::parse(text, std::ref(keys));
    } catch (const nlohmann::json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw ErrorException{{ErrorCode::input,
                              "this is not JSON from byte " + std::to_string(error.byte) + " on",
                              file + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')),
                              {}}};
    } catch (const nlohmann::json::out_of_range&) {
        throw ErrorException{{ErrorCode::input, "a number is too large to be held", file, {}}};
    }
}

bool isCaseFolder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ||
           (path.extension() == ".vestige" && !fs::is_regular_file(path, ignored));
}

std::string stemOfCase(const fs::path& file) {
    const fs::path absolute = fs::absolute(file).lexically_normal();
    const fs::path named = absolute.has_filename() ? absolute : absolute.parent_path();
    return named.filename() == "case.json" ? named.parent_path().stem().string() : named.stem().string();
}

}  // namespace

fs::path caseJsonPath(const fs::path& path) {
    return isCaseFolder(path) ? path / "case.json" : path;
}

bool looksLikeCase(const fs::path& path) {
    std::string extension = path.extension().string();
    if (!path.has_filename()) extension = path.parent_path().extension().string();
    std::error_code ignored;
    return extension == ".vestige" || extension == ".json" ||
           fs::is_regular_file(path / "case.json", ignored);
}

Result<SceneState> readCase(const fs::path& file, std::vector<std::string>* warnings) {
    const fs::path json = caseJsonPath(file);
    return guarded(json.string(), [&]() -> Result<SceneState> {
        const auto text = readTextFile(json, kLargestFile);
        if (!text) return fail(text.error());
        const nlohmann::json tree = parse(*text, json.string());
        JsonSource source{json.string(), {}};
        SceneState scene;
        scene.file = file;
        readCaseJson(JsonCursor(tree, source), fs::absolute(json).lexically_normal().parent_path(), scene);
        if (scene.name.empty()) scene.name = stemOfCase(file);
        if (warnings) warnings->insert(warnings->end(), source.warnings.begin(), source.warnings.end());
        return scene;
    });
}

Status writeCase(const fs::path& file, const SceneState& scene) {
    const fs::path json = caseJsonPath(file);
    const Result<std::string> text = guarded(json.string(), [&]() -> Result<std::string> {
        const fs::path folder = fs::absolute(json).lexically_normal().parent_path();
        return prettyText(caseJson(scene, [&](const fs::path& path) {
            const fs::path absolute = scene.resolve(path);
            const fs::path relative = absolute.lexically_relative(folder);
            return (relative.empty() ? absolute : relative).generic_string();
        }));
    });
    if (!text) {
        Error error = text.error();
        error.code = ErrorCode::output;
        return fail(error);
    }
    return writeTextFile(json, *text);
}

std::string caseText(const SceneState& scene) {
    return caseJson(scene, [](const fs::path& path) { return path.generic_string(); })
        .dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace vestige
