#include "app/importer/ThreeMfColors.h"

#include <charconv>
#include <string_view>
#include <utility>

namespace vestige::importer {
namespace {

std::optional<std::uint32_t> number(const pugi::xml_attribute& attribute) {
    const std::string_view text = attribute.value();
    std::uint32_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// #RRGGBB or #RRGGBBAA.
std::optional<Color> colorOf(std::string_view text) {
    if (!text.starts_with('#') || (text.size() != 7 && text.size() != 9)) return std::nullopt;
    Color color{};
    for (std::size_t i = 0; i < 3; ++i) {
        std::uint16_t byte = 0;
        const char* at = text.data() + 1 + 2 * i;
        if (std::from_chars(at, at + 2, byte, 16).ptr != at + 2) return std::nullopt;
        color[i] = static_cast<std::uint16_t>(257 * byte);
    }
    return color;
}

}  // namespace

void ThreeMfColors::addGroup(pugi::xml_node group) {
    const auto id = number(group.attribute("id"));
    if (!id) return;
    std::vector<std::optional<Color>>& colors = groups_[*id];
    for (const pugi::xml_node entry : group.children()) {
        const pugi::xml_attribute named = entry.attribute("displaycolor");
        colors.push_back(colorOf(named ? named.value() : entry.attribute("color").value()));
    }
}

std::optional<Color> ThreeMfColors::find(std::optional<std::uint32_t> group,
                                         std::optional<std::uint32_t> index) const {
    if (!group || !index) return std::nullopt;
    const auto found = groups_.find(*group);
    if (found == groups_.end() || *index >= found->second.size()) return std::nullopt;
    return found->second[*index];
}

VertexColors::VertexColors(const ThreeMfColors& colors, pugi::xml_node object)
    : colors_(colors), group_(number(object.attribute("pid"))), index_(number(object.attribute("pindex"))) {}

void VertexColors::add(const Triangle& triangle, pugi::xml_node node) {
    const auto own = number(node.attribute("pid"));
    const auto group = own ? own : group_;
    const auto first = number(node.attribute("p1"));
    constexpr const char* kNames[] = {"p1", "p2", "p3"};
    for (std::size_t i = 0; i < 3; ++i) {
        auto index = number(node.attribute(kNames[i]));
        if (!index) index = first;
        if (!index && !own) index = index_;
        const std::optional<Color> color = colors_.find(group, index);
        color ? ++colored_ : ++bare_;
        if (!color) continue;
        if (triangle[i] >= found_.size()) found_.resize(triangle[i] + std::size_t{1});
        std::optional<Color>& there = found_[triangle[i]];
        contradict_ = contradict_ || (there && *there != *color);
        there = color;
    }
}

std::vector<Color> VertexColors::ofVertices(std::size_t vertices) && {
    if (colored_ == 0) return {};
    std::vector<Color> colors(vertices, Color{65535, 65535, 65535});
    for (std::size_t i = 0; i < found_.size(); ++i)
        if (found_[i]) colors[i] = *found_[i];
    return colors;
}

}  // namespace vestige::importer
