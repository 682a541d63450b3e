#include "app/importer/ThreeMfPart.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "app/importer/ThreeMfColors.h"
#include "core/base/Result.h"
#include "core/io/TextScanner.h"

namespace vestige::importer {
namespace {

std::string_view localName(const char* name) {
    const std::string_view whole(name);
    const std::size_t colon = whole.find(':');
    return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

bool hasPrefix(const char* name) {
    return std::string_view(name).find(':') != std::string_view::npos;
}

class PartReader {
  public:
    explicit PartReader(std::string part) : place_(std::move(part)) {}

    ThreeMfPart read(std::vector<std::byte>& xml) {
        pugi::xml_document document;
        const pugi::xml_parse_result parsed = document.load_buffer_inplace(
            xml.data(), xml.size(), pugi::parse_escapes | pugi::parse_wconv_attribute | pugi::parse_doctype);
        if (parsed.status == pugi::status_out_of_memory) throw std::bad_alloc();
        if (!parsed)
            refuse("is no XML: " + std::string(parsed.description()) + " at byte " +
                   std::to_string(parsed.offset));
        for (const pugi::xml_node node : document.children())
            if (node.type() == pugi::node_doctype) refuse("holds a document type definition");
        const pugi::xml_node model = document.document_element();
        if (localName(model.name()) != "model") refuse("holds no <model>");
        readUnit(model.attribute("unit").as_string("millimeter"));
        checkExtensions(model);
        for (const pugi::xml_node section : model.children()) {
            if (hasPrefix(section.name()) != hasPrefix(model.name())) continue;
            if (localName(section.name()) == "resources") readResources(section);
            if (localName(section.name()) == "build")
                for (const pugi::xml_node item : section.children())
                    if (localName(item.name()) == "item") part_.build.push_back(readPlace(item));
        }
        return std::move(part_);
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw ErrorException{{ErrorCode::input, "the part '" + place_ + "' " + what, {}, "a 3MF model"}};
    }

    void readUnit(std::string_view unit) {
        constexpr std::pair<std::string_view, double> kUnits[] = {{"micron", 1e-6},     {"millimeter", 1e-3},
                                                                  {"centimeter", 1e-2}, {"inch", 0.0254},
                                                                  {"foot", 0.3048},     {"meter", 1}};
        for (const auto& [name, metres] : kUnits)
            if (unit == name) {
                part_.metresPerUnit = metres;
                return;
            }
        refuse("names the unknown unit '" + std::string(unit) + "'");
    }

    void checkExtensions(pugi::xml_node model) const {
        constexpr std::string_view kKnown[] = {
            "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
            "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
            "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
            "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"};
        std::string_view required = model.attribute("requiredextensions").as_string();
        for (auto prefix = takeToken(required); !prefix.empty(); prefix = takeToken(required)) {
            const std::string_view space =
                model.attribute(("xmlns:" + std::string(prefix)).c_str()).as_string();
            if (std::find(std::begin(kKnown), std::end(kKnown), space) == std::end(kKnown))
                refuse("requires the extension '" + std::string(space.empty() ? prefix : space) +
                       "', which is not read here");
        }
    }

    void readResources(pugi::xml_node resources) {
        for (const pugi::xml_node resource : resources.children()) {
            const std::string_view name = localName(resource.name());
            if (name == "object")
                readObject(resource);
            else if (name == "basematerials" || name == "colorgroup")
                colors_.addGroup(resource);
            else if (name == "texture2d" || name == "texture2dgroup" || name == "compositematerials" ||
                     name == "multiproperties")
                part_.passedOver.insert("textures and mixed materials");
            else if (name == "slicestack")
                part_.passedOver.insert("slices");
        }
    }

    void readObject(pugi::xml_node node) {
        ThreeMfObject object;
        for (const pugi::xml_node child : node.children()) {
            if (hasPrefix(child.name()) != hasPrefix(node.name())) continue;
            if (localName(child.name()) == "mesh") readMesh(node, child, object.mesh);
            if (localName(child.name()) == "components")
                for (const pugi::xml_node component : child.children())
                    if (localName(component.name()) == "component")
                        object.components.push_back(readPlace(component));
        }
        if (!part_.objects.emplace(whole(node, "id"), std::move(object)).second)
            refuse("has two objects of the number " + std::to_string(whole(node, "id")));
    }

    void readMesh(pugi::xml_node object, pugi::xml_node node, ImportedMesh& mesh) {
        VertexColors colors(colors_, object);
        for (const pugi::xml_node list : node.children()) {
            const bool own = hasPrefix(list.name()) == hasPrefix(node.name());
            const std::string_view name = localName(list.name());
            if (own && name == "vertices")
                for (const pugi::xml_node vertex : list.children())
                    mesh.vertices.emplace_back(real(vertex, "x"), real(vertex, "y"), real(vertex, "z"));
            else if (own && name == "triangles")
                for (const pugi::xml_node corner : list.children()) {
                    const Triangle triangle{whole(corner, "v1"), whole(corner, "v2"), whole(corner, "v3")};
                    for (const std::uint32_t index : triangle)
                        if (index >= mesh.vertices.size())
                            refuse("has a triangle of vertex " + std::to_string(index) + ", of " +
                                   std::to_string(mesh.vertices.size()));
                    mesh.triangles.push_back(triangle);
                    colors.add(triangle, corner);
                }
            else if (name == "beamlattice")
                part_.passedOver.insert("beam lattices");
        }
        if (colors.contradict())
            part_.passedOver.insert("different colours of the triangles at one vertex");
        else
            mesh.colors = std::move(colors).ofVertices(mesh.vertices.size());
    }

    ThreeMfPlace readPlace(pugi::xml_node node) const {
        ThreeMfPlace place;
        place.object = whole(node, "objectid");
        for (const pugi::xml_attribute attribute : node.attributes())
            if (hasPrefix(attribute.name()) && localName(attribute.name()) == "path") {
                std::string_view path = attribute.value();
                if (path.starts_with('/')) path.remove_prefix(1);
                place.part = path;
            }
        if (const pugi::xml_attribute text = node.attribute("transform")) {
            // Row vectors: the first three numbers are what becomes of x, the last three the translation.
            TextScanner numbers(text.value());
            for (int i = 0; i < 12; ++i) {
                const auto number = numbers.nextNumber();
                if (!number || !std::isfinite(*number)) refuse("has a transform that is not twelve numbers");
                place.transform.matrix()(i % 3, i / 3) = *number;
            }
            if (!numbers.nextToken().empty()) refuse("has a transform that is not twelve numbers");
        }
        return place;
    }

    double real(pugi::xml_node node, const char* name) const {
        const std::string_view text = node.attribute(name).value();
        const char* at = text.data();
        const auto number = takeNumber(at, text.data() + text.size());
        if (!number || at != text.data() + text.size() || !std::isfinite(*number))
            refuse("has a coordinate that is missing or no finite number");
        return *number;
    }

    std::uint32_t whole(pugi::xml_node node, const char* name) const {
        const std::string_view text = node.attribute(name).value();
        std::uint32_t number = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (problem != std::errc{} || end != text.data() + text.size())
            refuse("has a number '" + std::string(name) + "' that is missing or none");
        return number;
    }

    std::string place_;
    ThreeMfPart part_;
    ThreeMfColors colors_;
};

}  // namespace

ThreeMfPart parseThreeMfPart(std::vector<std::byte>& xml, const std::string& part) {
    return PartReader(part).read(xml);
}

}  // namespace vestige::importer
