#include "core/scene/casefile/CaseText.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/CleanText.h"
#include "core/base/JsonSize.h"
#include "core/scene/CaseFile.h"
#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostValues = 1000000;
constexpr int kDeepest = 64;

/// Refuses a text that would make a tree too deep or too large, before there is any.
void checkSize(const std::string& text, const std::string& file) {
    const JsonSize size = jsonSize(text);
    if (size.depth > kDeepest)
        throw ErrorException{{ErrorCode::input, "the JSON is nested deeper than any case", file, {}}};
    if (size.values > kMostValues)
        throw ErrorException{{ErrorCode::input, "the JSON holds more values than any case", file, {}}};
}

/// Refuses a key that stands twice in one object: which of the two counts, every reader of JSON decides for
/// itself.
class KeyWatch {
  public:
    using Event = nlohmann::json::parse_event_t;
    explicit KeyWatch(const std::string& file) : file_(file) {}

    bool operator()(int, Event event, nlohmann::json& parsed) {
        if (event == Event::object_start) seen_.emplace_back();
        if (event == Event::object_end) seen_.pop_back();
        if (event == Event::key && !seen_.back().insert(parsed.get<std::string>()).second)
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
    if (text && text->size() > kLargestCaseText)
        return fail(ErrorCode::output,
                    "the case would hold " + std::to_string(text->size() >> 20) + " MB, more than the " +
                        std::to_string(kLargestCaseText >> 20) + " MB that are read again",
                    folder.string(), "forget some of the parts of the scene, or bring points back");
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
