#include "core/io/formats/E57Xml.h"

#include <cmath>
#include <cstring>
#include <pugixml.hpp>

#include "core/base/Numbers.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

constexpr double kUnitTolerance = 1e-3;

/// Foreign text in a sentence: short.
std::string shown(const pugi::xml_node& node) {
    std::string text;
    for (const char c : std::string_view(node.name()).substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
    return "'" + text + "'";
}

}  // namespace

const char* localName(const pugi::xml_node& node) {
    const char* colon = std::strrchr(node.name(), ':');
    return colon ? colon + 1 : node.name();
}

std::size_t E57Xml::byteOf(const pugi::xml_node& node) const {
    const std::ptrdiff_t at = node.offset_debug();
    return pages_.physical(pages_.xmlOffset() + static_cast<std::uint64_t>(at > 0 ? at : 0));
}

void E57Xml::refuse(const pugi::xml_node& node, std::string message, const std::string& expected) const {
    job_.refuseByte(byteOf(node), std::move(message), expected);
}

std::string E57Xml::textOf(const pugi::xml_node& parent, const char* child) {
    // "]]>" cannot stand in one CDATA section, so that a text may come in several.
    std::string text;
    for (const pugi::xml_node part : parent.child(child).children())
        if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) text += part.value();
    return text;
}

double E57Xml::realOf(const pugi::xml_node& node) const {
    const std::string_view text = trimmed(node.text().get());
    if (text.empty()) return 0;
    const std::optional<double> number = parseReal(text);
    if (!number) refuse(node, shown(node) + " is no number", "a decimal number");
    return *number;
}

std::optional<double> E57Xml::realOf(const pugi::xml_node& parent, const char* child) const {
    const pugi::xml_node node = parent.child(child);
    if (!node) return std::nullopt;
    return realOf(node);
}

std::optional<double> E57Xml::attribute(const pugi::xml_node& node, const char* name) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) return std::nullopt;
    const std::optional<double> number = parseReal(trimmed(attribute.value()));
    if (!number || !std::isfinite(*number))
        refuse(node, std::string(name) + " of " + shown(node) + " is no finite number", "a decimal number");
    return number;
}

std::optional<std::int64_t> E57Xml::integerAttribute(const pugi::xml_node& node, const char* name) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) return std::nullopt;
    const std::optional<std::int64_t> number = parseInteger(trimmed(attribute.value()));
    if (!number) refuse(node, std::string(name) + " of " + shown(node) + " is no integer", "an integer");
    return number;
}

std::optional<Pose> E57Xml::poseOf(const pugi::xml_node& parent) const {
    const pugi::xml_node node = parent.child("pose");
    if (!node) return std::nullopt;
    Pose pose = Pose::Identity();
    if (const pugi::xml_node rotation = node.child("rotation")) {
        const auto part = [&](const char* name) { return realOf(rotation, name).value_or(0); };
        const Eigen::Quaterniond quaternion(part("w"), part("x"), part("y"), part("z"));
        const double length = quaternion.norm();
        if (!(std::abs(length - 1) < kUnitTolerance))
            refuse(rotation, "the rotation of the pose is no unit quaternion", "w, x, y, z of length 1");
        pose.linear() = quaternion.normalized().toRotationMatrix();
    }
    if (const pugi::xml_node translation = node.child("translation")) {
        constexpr std::array kAxes{"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis)
            pose.translation()[axis] = realOf(translation, kAxes[axis]).value_or(0);
        if (!pose.translation().allFinite())
            refuse(translation, "the translation of the pose is not finite", "finite numbers of metres");
    }
    return pose;
}

std::uint64_t E57Xml::sectionOf(const pugi::xml_node& node) const {
    const std::optional<std::int64_t> offset = integerAttribute(node, "fileOffset");
    if (!offset || *offset < 0) refuse(node, shown(node) + " does not say where it is", "a fileOffset");
    return pages_.logical(static_cast<std::uint64_t>(*offset), shown(node), byteOf(node), job_);
}

}  // namespace vestige
