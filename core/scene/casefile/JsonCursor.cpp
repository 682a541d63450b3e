#include "core/scene/casefile/JsonCursor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/CleanText.h"
#include "core/base/Result.h"
#include "core/io/Coordinates.h"

namespace vestige {

namespace {

constexpr std::size_t kLongestSentence = 300;
constexpr std::size_t kMostWarnings = 100;

}  // namespace

std::string JsonCursor::pathOf(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

std::string JsonCursor::place() const {
    return path_.empty() ? source_->file : source_->file + ": " + cleanText(path_, kLongestSentence);
}

void JsonCursor::reject(std::string message, std::string hint) const {
    throw ErrorException{{ErrorCode::input, cleanText(message, kLongestSentence), place(), std::move(hint)}};
}

void JsonCursor::expected(std::string_view what) const {
    constexpr std::size_t kLongest = 60;
    // Only scalars are shown: dumping an unknown tree would recurse as deep as its author liked.
    std::string found = value_->is_structured()
                            ? (value_->is_array() ? "an array" : "an object")
                            : value_->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (found.size() > kLongest) found = found.substr(0, kLongest) + "...";
    reject("there is " + found + " here", "expected " + std::string(what));
}

void JsonCursor::warn(const std::string& message) const {
    if (source_->warnings.size() < kMostWarnings) source_->warnings.push_back(place() + ": " + message);
}

void JsonCursor::warnOfOthers(std::initializer_list<std::string_view> known) const {
    for (const auto& [key, member] : members())
        if (std::find(known.begin(), known.end(), key) == known.end())
            member.warn("Vestige does not know this key and leaves it out");
}

bool JsonCursor::isObject() const {
    return value_->is_object();
}
bool JsonCursor::isArray() const {
    return value_->is_array();
}
bool JsonCursor::isText() const {
    return value_->is_string();
}

bool JsonCursor::contains(std::string_view key) const {
    if (!value_->is_object()) expected("an object");
    return value_->contains(key);
}

std::optional<JsonCursor> JsonCursor::find(std::string_view key) const {
    if (!contains(key)) return std::nullopt;
    const nlohmann::json& member = value_->at(std::string(key));
    if (member.is_null()) return std::nullopt;
    return below(member, pathOf(key));
}

JsonCursor JsonCursor::at(std::string_view key) const {
    auto member = find(key);
    if (!member) reject("the key \"" + std::string(key) + "\" is missing");
    return *member;
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
    if (!value_->is_object()) expected("an object");
    std::vector<std::pair<std::string, JsonCursor>> found;
    for (const auto& [key, member] : value_->items()) found.emplace_back(key, below(member, pathOf(key)));
    return found;
}

std::vector<JsonCursor> JsonCursor::elements() const {
    if (!value_->is_array()) expected("an array");
    std::vector<JsonCursor> found;
    for (std::size_t i = 0; i < value_->size(); ++i)
        found.push_back(below((*value_)[i], path_ + "[" + std::to_string(i) + "]"));
    return found;
}

std::vector<JsonCursor> JsonCursor::elements(std::size_t count, std::string_view what) const {
    if (!value_->is_array()) expected(what);
    if (value_->size() != count)
        reject("there are " + std::to_string(value_->size()) + " values here",
               "expected " + std::string(what));
    return elements();
}

std::string JsonCursor::text() const {
    if (!value_->is_string()) expected("text");
    return value_->get<std::string>();
}

std::string JsonCursor::name() const {
    std::string value = text();
    if (value.empty()) reject("the text is empty", "expected a name");
    return value;
}

bool JsonCursor::boolean() const {
    if (!value_->is_boolean()) expected("true or false");
    return value_->get<bool>();
}

double JsonCursor::real() const {
    if (!value_->is_number()) expected("a number");
    const auto number = value_->get<double>();
    if (!std::isfinite(number)) expected("a finite number");
    return number;
}

double JsonCursor::realAbove0() const {
    const double number = real();
    if (!(number > 0)) expected("a number above 0");
    return number;
}

double JsonCursor::realOrNull() const {
    return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : real();
}

std::int64_t JsonCursor::integer(std::int64_t minimum, std::int64_t maximum) const {
    const std::string what =
        "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum);
    if (!value_->is_number()) expected(what);
    const auto number = value_->get<double>();
    if (!(number >= static_cast<double>(minimum) && number <= static_cast<double>(maximum)) ||
        number != std::floor(number))
        expected(what);
    return static_cast<std::int64_t>(number);
}

Eigen::Vector3d JsonCursor::vector3() const {
    const auto numbers = elements(3, "a point [x, y, z]");
    const Eigen::Vector3d point(numbers[0].real(), numbers[1].real(), numbers[2].real());
    if (!isUsable(point))
        reject("the point is farther from 0 than any place on Earth", "expected up to 1e10");
    return point;
}

}  // namespace vestige
