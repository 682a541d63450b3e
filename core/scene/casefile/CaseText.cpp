#include "core/scene/casefile/CaseText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/scene/CaseFile.h"
#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

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

nlohmann::json parse(const std::string& text, const std::string& file) {
    checkSize(text, file);
    try {
        return nlohmann::json::parse(text);
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

}  // namespace

Result<SceneState> sceneFromText(const std::string& text, const std::string& place, const fs::path& folder,
                                 std::vector<std::string>* warnings) {
    return guarded(place, [&]() -> Result<SceneState> {
        const nlohmann::json tree = parse(text, place);
        JsonSource source{place, {}};
        SceneState scene;
        readCaseJson(JsonCursor(tree, source), folder, scene);
        if (warnings) warnings->insert(warnings->end(), source.warnings.begin(), source.warnings.end());
        return scene;
    });
}

Result<std::string> textInFolder(const SceneState& scene, const fs::path& folder) {
    auto text = guarded(folder.string(), [&]() -> Result<std::string> {
        return prettyText(caseJson(scene, [&](const fs::path& path) {
            const fs::path absolute = scene.resolve(path);
            const fs::path relative = absolute.lexically_relative(folder);
            return (relative.empty() ? absolute : relative).generic_string();
        }));
    });
    if (text) return text;
    Error error = text.error();
    error.code = ErrorCode::output;
    return fail(error);
}

std::string caseText(const SceneState& scene) {
    return caseJson(scene, [](const fs::path& path) { return path.generic_string(); })
        .dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace vestige
