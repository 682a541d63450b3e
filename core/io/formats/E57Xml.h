#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/geometry/Pose.h"
#include "core/io/formats/E57Pages.h"

namespace pugi {
class xml_node;
}

namespace vestige {

/// Values of the XML section's elements; each refuses at the element's byte what is no value of its type. An
/// element without content is 0 or empty (ASTM E2807, 8.4).
class E57Xml {
  public:
    E57Xml(const E57Pages& pages, ReadJob& job) : pages_(pages), job_(job) {}

    ReadJob& job() const { return job_; }
    const E57Pages& pages() const { return pages_; }
    /// The element's byte in the file.
    std::size_t byteOf(const pugi::xml_node& node) const;
    [[noreturn]] void refuse(const pugi::xml_node& node, std::string message,
                             const std::string& expected = {}) const;

    static std::string textOf(const pugi::xml_node& parent, const char* child);
    double realOf(const pugi::xml_node& node) const;
    std::optional<double> realOf(const pugi::xml_node& parent, const char* child) const;
    std::optional<double> attribute(const pugi::xml_node& node, const char* name) const;
    std::optional<std::int64_t> integerAttribute(const pugi::xml_node& node, const char* name) const;
    /// The child "pose": a unit quaternion and a translation; nothing where there is none.
    std::optional<Pose> poseOf(const pugi::xml_node& parent) const;
    /// Where the section begins (logical) that a CompressedVector or Blob points to.
    std::uint64_t sectionOf(const pugi::xml_node& node) const;

  private:
    const E57Pages& pages_;
    ReadJob& job_;
};

/// The name without the prefix of its namespace.
const char* localName(const pugi::xml_node& node);

}  // namespace vestige
