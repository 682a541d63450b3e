#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vestige {

/// What all cursors of one file share.
struct JsonSource {
    std::string file;
    std::vector<std::string> warnings;
};

/// A value of a JSON file together with its path ("layers[1].unit"). Every function that finds something else
/// than it was asked for throws an ErrorException that names file and path; use inside `guarded`.
class JsonCursor {
  public:
    JsonCursor(const nlohmann::json& value, JsonSource& source, std::string path = {})
        : value_(&value), source_(&source), path_(std::move(path)) {}

    const std::string& path() const { return path_; }
    const nlohmann::json& value() const { return *value_; }

    /// The member of an object; nothing when it is absent or null.
    std::optional<JsonCursor> find(std::string_view key) const;
    JsonCursor at(std::string_view key) const;
    /// True for a member that is there, null included.
    bool contains(std::string_view key) const;
    std::vector<std::pair<std::string, JsonCursor>> members() const;
    std::vector<JsonCursor> elements() const;
    std::vector<JsonCursor> elements(std::size_t count, std::string_view what) const;
    bool isObject() const;
    bool isArray() const;
    bool isText() const;

    std::string text() const;
    /// Text of one character or more.
    std::string name() const;
    bool boolean() const;
    /// Any finite number.
    double real() const;
    double realAbove0() const;
    /// A number, or not-a-number for null: what JSON writes for it.
    double realOrNull() const;
    std::int64_t integer(std::int64_t minimum, std::int64_t maximum) const;
    Eigen::Vector3d vector3() const;

    /// Warns of every member that is not listed: "front.json: layers[1].uint is not a key that ...".
    void warnOfOthers(std::initializer_list<std::string_view> known) const;
    void warn(const std::string& message) const;
    [[noreturn]] void reject(std::string message, std::string hint = {}) const;

  private:
    JsonCursor below(const nlohmann::json& value, std::string path) const {
        return {value, *source_, std::move(path)};
    }
    std::string pathOf(std::string_view key) const;
    std::string place() const;
    [[noreturn]] void expected(std::string_view what) const;

    const nlohmann::json* value_;
    JsonSource* source_;
    std::string path_;
};

}  // namespace vestige
