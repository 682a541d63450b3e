#include "core/scene/picks/PickLabel.h"

#include <vector>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr std::string_view kBar = " | ";
/// More repeats or corners than anybody picks.
constexpr std::int64_t kMost = 100'000;

std::optional<std::size_t> ordinal(const std::string& text) {
    const auto value = parseInteger(text);
    if (!value || *value < 1 || *value > kMost) return std::nullopt;
    return static_cast<std::size_t>(*value);
}

/// Sets which end it is; false for what names none.
bool takeEnd(const std::string& text, PickLabel& label) {
    label.ofPath = text != "a" && text != "b";
    if (!label.ofPath) {
        label.end = text == "a" ? 0 : 1;
        return true;
    }
    if (!text.starts_with('p')) return false;
    const auto corner = ordinal(text.substr(1));
    if (corner) label.end = *corner - 1;
    return corner.has_value();
}

/// The last `count` parts; the first of the result is all that stands before them.
std::vector<std::string> lastParts(const std::string& text, std::size_t count) {
    std::vector<std::string> parts(count + 1);
    std::size_t end = text.size();
    for (std::size_t i = count; i > 0; --i) {
        const std::size_t bar = end == 0 ? std::string::npos : text.rfind(kBar, end - 1);
        if (bar == std::string::npos || bar + kBar.size() > end) return {};
        parts[i] = text.substr(bar + kBar.size(), end - bar - kBar.size());
        end = bar;
    }
    parts[0] = text.substr(0, end);
    return parts;
}

std::optional<PickLabel> labelOf(const std::vector<std::string>& parts, bool withLayer) {
    if (parts.empty() || parts[0].empty() || parts[1].empty()) return std::nullopt;
    PickLabel label;
    label.object = parts[0];
    label.key = parts[1];
    label.layer = withLayer ? parts[4] : label.key;
    const auto repeat = ordinal(parts[2]);
    if (!repeat || label.layer.empty() || !takeEnd(parts[3], label)) return std::nullopt;
    label.repeat = *repeat;
    return label;
}

}  // namespace

std::string textOf(const PickLabel& label) {
    const std::string end =
        label.ofPath ? "p" + std::to_string(label.end + 1) : std::string(label.end == 0 ? "a" : "b");
    std::string text = label.object;
    for (const std::string& part : {label.key, std::to_string(label.repeat), end})
        text += std::string(kBar) + part;
    if (label.layer != label.key) text += std::string(kBar) + label.layer;
    return text;
}

std::optional<PickLabel> parsePickLabel(const std::string& text) {
    // An end is no number, a repeat is one: only one of both readings is possible.
    if (auto plain = labelOf(lastParts(text, 3), false)) return plain;
    return labelOf(lastParts(text, 4), true);
}

}  // namespace vestige
