#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/ReadJob.h"

namespace vestige {

/// Reads a JSON text; refuses at the byte where it is none, and what is nested deeper than 64.
nlohmann::json parseGltfJson(std::string_view text, std::size_t byteOfText, const ReadJob& job);

/// Values of a glTF document, each of the type that the specification gives it, or refused by its name.
class GltfJson {
  public:
    GltfJson(const nlohmann::json& document, const ReadJob& job) : document_(document), job_(job) {}

    const nlohmann::json& document() const { return document_; }
    const ReadJob& job() const { return job_; }

    /// How many items a list of the document has ("nodes"); 0 where it is missing.
    std::size_t count(const char* list) const;
    /// Item `index` of a list of the document; `why` says who names it ("a scene").
    const nlohmann::json& item(const char* list, std::uint64_t index, const std::string& why) const;

    std::optional<std::uint64_t> find(const nlohmann::json& object, const char* key) const;
    std::uint64_t number(const nlohmann::json& object, const char* key) const;
    std::uint64_t number(const nlohmann::json& object, const char* key, std::uint64_t otherwise) const;
    std::string text(const nlohmann::json& object, const char* key) const;
    bool flag(const nlohmann::json& object, const char* key) const;
    /// Whole numbers from 0; empty where the key is missing.
    std::vector<std::uint64_t> numbers(const nlohmann::json& object, const char* key) const;
    /// `length` finite numbers; nothing where the key is missing.
    std::optional<std::vector<double>> reals(const nlohmann::json& object, const char* key,
                                             std::size_t length) const;
    std::vector<std::string> texts(const nlohmann::json& object, const char* key) const;

  private:
    const nlohmann::json* member(const nlohmann::json& object, const char* key) const;
    [[noreturn]] void refuse(const char* key, const std::string& expected) const;

    const nlohmann::json& document_;
    const ReadJob& job_;
};

}  // namespace vestige
