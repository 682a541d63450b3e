#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "core/geometry/TriangleMesh.h"

namespace vestige::importer {

/// The colours of a part's base materials and colour groups, by group and place in it.
class ThreeMfColors {
  public:
    /// A <basematerials> or <colorgroup>; entries without a colour stay without.
    void addGroup(pugi::xml_node group);
    std::optional<Color> find(std::optional<std::uint32_t> group, std::optional<std::uint32_t> index) const;

  private:
    std::map<std::uint32_t, std::vector<std::optional<Color>>> groups_;
};

/// The colours that an object's triangles give to its vertices.
class VertexColors {
  public:
    VertexColors(const ThreeMfColors& colors, pugi::xml_node object);

    /// `node` is the <triangle>: pid, p1, p2, p3, else what the object says.
    void add(const Triangle& triangle, pugi::xml_node node);
    /// Triangles that meet at a vertex give it different colours, or only some give it one.
    bool contradict() const { return contradict_ || (colored_ > 0 && bare_ > 0); }
    /// One colour a vertex, or nothing where there is none; vertices of no triangle are white.
    std::vector<Color> ofVertices(std::size_t vertices) &&;

  private:
    const ThreeMfColors& colors_;
    std::optional<std::uint32_t> group_, index_;
    std::vector<std::optional<Color>> found_;
    std::size_t colored_ = 0, bare_ = 0;
    bool contradict_ = false;
};

}  // namespace vestige::importer
