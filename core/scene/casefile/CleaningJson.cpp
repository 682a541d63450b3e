#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

/// "gap length gap length ...": how many points stay before each run, and how many it has.
std::string runsText(const PointSet& points) {
    std::string text;
    text.reserve(6 * points.runs().size());
    const auto add = [&text](std::uint32_t number) {
        std::array<char, 12> digits;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        if (!text.empty()) text += ' ';
        text.append(digits.data(), end);
    };
    std::uint32_t at = 0;
    for (const auto& [first, last] : points.runs()) {
        add(first - at);
        add(last - first);
        at = last;
    }
    return text;
}

PointSet readRuns(const JsonCursor& cursor, std::uint32_t count) {
    constexpr const char* kForm =
        "expected \"gap length gap length ...\", whole numbers with one space between";
    const std::string text = cursor.text();
    std::vector<PointSet::Run> runs;
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto number = [&]() -> std::uint32_t {
        std::uint32_t value = 0;
        const auto [next, problem] = std::from_chars(at, end, value);
        if (problem != std::errc()) {
            const auto place = std::to_string(at - text.data());
            cursor.reject("there is no number of points at character " + place + " of the runs", kForm);
        }
        at = next;
        return value;
    };
    const auto space = [&] {
        if (at == end || *at != ' ') cursor.reject("the runs end within a pair", kForm);
        ++at;
    };
    std::uint64_t reached = 0;
    while (at != end) {
        const std::uint64_t first = reached + number();
        space();
        const std::uint64_t last = first + number();
        if (last == first || (!runs.empty() && first == reached))
            cursor.reject("run " + std::to_string(runs.size() + 1) + " is empty or touches the one before it",
                          kForm);
        if (last > count)
            cursor.reject("the runs reach beyond the layer's " + std::to_string(count) + " points", kForm);
        runs.emplace_back(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last));
        reached = last;
        if (at != end) space();
        if (at == end && text.back() == ' ') cursor.reject("the runs end with a space", kForm);
    }
    if (runs.empty()) cursor.reject("there are no points here", kForm);
    return PointSet::fromRuns(std::move(runs));
}

std::uint32_t readCount(const JsonCursor& cursor) {
    return static_cast<std::uint32_t>(cursor.integer(1, std::numeric_limits<std::uint32_t>::max()));
}

std::string readHash(const JsonCursor& cursor) {
    const std::string text = cursor.text();
    if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string::npos)
        cursor.reject("this is no SHA-256", "expected 64 lower-case hexadecimal digits");
    return text;
}

}  // namespace

Json cleaningJson(const Cleaning& cleaning) {
    Json steps = Json::array();
    for (const CleaningStep& step : cleaning.steps)
        steps.push_back({{"how", step.how}, {"parameters", step.parameters}, {"points", step.points}});
    return {{"of", cleaning.loadedPoints},
            {"sha256", cleaning.sha256},
            {"steps", std::move(steps)},
            {"removed", runsText(cleaning.removed)}};
}

std::shared_ptr<const Cleaning> readCleaning(const JsonCursor& cursor) {
    cursor.warnOfOthers({"of", "sha256", "steps", "removed"});
    auto cleaning = std::make_shared<Cleaning>();
    cleaning->loadedPoints = readCount(cursor.at("of"));
    cleaning->sha256 = readHash(cursor.at("sha256"));
    cleaning->removed = readRuns(cursor.at("removed"), cleaning->loadedPoints);
    if (cleaning->removed.size() == cleaning->loadedPoints)
        cursor.at("removed").reject("nothing is left of the layer", "expected fewer points than it has");
    if (const auto steps = cursor.find("steps"))
        for (const auto& item : steps->elements()) {
            item.warnOfOthers({"how", "parameters", "points"});
            CleaningStep step{item.at("how").name(), {}, readCount(item.at("points"))};
            if (const auto parameters = item.find("parameters")) step.parameters = parameters->text();
            cleaning->steps.push_back(std::move(step));
        }
    return cleaning;
}

Json objectJson(const SceneObject& object) {
    return {{"name", object.name},
            {"kind", object.kind},
            {"layer", object.layer},
            {"of", object.loadedPoints},
            {"sha256", object.sha256},
            {"size_m", object.size_m},
            {"found", object.found},
            {"visible", object.visible},
            {"points", object.points ? runsText(*object.points) : std::string()}};
}

SceneObject readObject(const JsonCursor& cursor) {
    cursor.warnOfOthers({"name", "kind", "layer", "of", "sha256", "size_m", "found", "visible", "points"});
    SceneObject object;
    object.name = cursor.at("name").name();
    object.kind = cursor.at("kind").text();
    const auto& kinds = objectKinds();
    if (std::find(kinds.begin(), kinds.end(), object.kind) == kinds.end())
        cursor.at("kind").reject("'" + object.kind + "' is no kind of object",
                                 "expected vehicle, debris, vegetation, ground or other");
    object.layer = cursor.at("layer").name();
    object.loadedPoints = readCount(cursor.at("of"));
    object.sha256 = readHash(cursor.at("sha256"));
    if (const auto size = cursor.find("size_m")) {
        const auto sides = size->elements(3, "length, width and height");
        for (std::size_t i = 0; i < 3; ++i) {
            object.size_m[i] = sides[i].real();
            if (object.size_m[i] < 0) sides[i].reject("a length is not below 0");
        }
    }
    if (const auto found = cursor.find("found")) object.found = found->text();
    if (const auto visible = cursor.find("visible")) object.visible = visible->boolean();
    object.points = std::make_shared<const PointSet>(readRuns(cursor.at("points"), object.loadedPoints));
    return object;
}

}  // namespace vestige
