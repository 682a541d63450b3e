#include <nlohmann/json.hpp>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

constexpr std::size_t kLineLength = 110;

void write(const nlohmann::ordered_json& tree, std::size_t indent, std::string& text) {
    const std::string inOneLine = tree.dump();
    if (!tree.is_structured() || tree.empty() || indent + inOneLine.size() <= kLineLength) {
        text += inOneLine;
        return;
    }
    const std::string margin(indent + 2, ' ');
    text += tree.is_array() ? "[\n" : "{\n";
    bool first = true;
    for (const auto& [key, value] : tree.items()) {
        if (!first) text += ",\n";
        first = false;
        text += margin;
        if (tree.is_object()) text += nlohmann::ordered_json(key).dump() + ": ";
        write(value, indent + 2, text);
    }
    text += "\n" + std::string(indent, ' ') + (tree.is_array() ? "]" : "}");
}

}  // namespace

std::string prettyText(const nlohmann::ordered_json& tree) {
    std::string text;
    write(tree, 0, text);
    return text + "\n";
}

}  // namespace vestige
