#include "app/importer/ThreeMfModel.h"

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "app/importer/ThreeMfCheck.h"
#include "app/importer/ThreeMfPart.h"
#include "app/importer/ZipPart.h"

namespace vestige::importer {
namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMostInstances = 1'000'000;
constexpr const char* kModelType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

[[noreturn]] void refuse(const std::string& message, const std::string& expected) {
    throw ErrorException{{ErrorCode::input, message, {}, expected}};
}

class Model {
  public:
    explicit Model(std::span<const std::byte> archive) : archive_(archive), job_({}, JobControl()) {
        for (ZipEntry& entry : readZipDirectory(archive, {}, job_)) {
            std::string name = entry.name;
            entries_.emplace(std::move(name), std::move(entry));
        }
        root_ = rootPart();
        load(root_);
        for (const ThreeMfPlace& item : parts_.at(root_).build)
            place(item, root_, Eigen::Affine3d::Identity(), 0);
    }

    void send(ImportSender& sender) {
        sender.unit(parts_.at(root_).metresPerUnit);
        for (const std::string& what : passedOver_) sender.warning(what + " are left out");
        for (const ImportedMesh* mesh : meshes_) sender.mesh(*mesh);
        sender.instances(instances_);
    }

    std::uint64_t vertices() const {
        return sum([](const ImportedMesh& m) { return m.vertices.size(); });
    }
    std::uint64_t triangles() const {
        return sum([](const ImportedMesh& m) { return m.triangles.size(); });
    }

  private:
    std::uint64_t sum(const auto& count) const {
        std::uint64_t total = 0;
        for (const auto& [name, part] : parts_)
            for (const auto& [id, object] : part.objects) total += count(object.mesh);
        return total;
    }

    std::vector<std::byte> content(const std::string& name) const {
        const auto entry = entries_.find(name);
        if (entry == entries_.end())
            refuse("the part '" + name + "' is missing in the archive", "every part that the file names");
        return inflated(archive_, entry->second);
    }

    std::string rootPart() const {
        std::vector<std::byte> xml = content("_rels/.rels");
        pugi::xml_document document;
        if (!document.load_buffer_inplace(xml.data(), xml.size()))
            refuse("the part '_rels/.rels' is no XML", "a 3MF archive");
        for (const pugi::xml_node relation : document.document_element().children())
            if (std::string_view(relation.attribute("Type").value()) == kModelType) {
                std::string_view target = relation.attribute("Target").value();
                if (target.starts_with('/')) target.remove_prefix(1);
                return std::string(target);
            }
        refuse("the archive names no 3D model", "a relationship to a model in _rels/.rels");
    }

    void load(const std::string& name) {
        std::vector<std::byte> xml = content(name);
        ThreeMfPart part = parseThreeMfPart(xml, name);
        passedOver_.insert(part.passedOver.begin(), part.passedOver.end());
        std::set<std::string> others;
        for (const ThreeMfPlace& item : part.build) others.insert(item.part);
        for (const auto& [id, object] : part.objects)
            for (const ThreeMfPlace& component : object.components) others.insert(component.part);
        parts_.emplace(name, std::move(part));
        for (const std::string& other : others)
            if (!other.empty() && !parts_.contains(other)) load(other);
    }

    void place(const ThreeMfPlace& at, const std::string& part, const Eigen::Affine3d& outer, int depth) {
        const std::string& home = at.part.empty() ? part : at.part;
        const auto& objects = parts_.at(home).objects;
        const auto found = objects.find(at.object);
        if (found == objects.end())
            refuse("object " + std::to_string(at.object) + " is not in the part '" + home + "'",
                   "an object for every build item and component");
        if (depth > kDeepest || ++places_ > kMostInstances)
            refuse("objects hold each other too often or too deep",
                   "at most " + std::to_string(kMostInstances) + " places, " + std::to_string(kDeepest) +
                       " components deep");
        const Eigen::Affine3d here = outer * at.transform;
        const ThreeMfObject& object = found->second;
        if (!object.mesh.vertices.empty()) {
            const auto [known, isNew] =
                numbers_.emplace(&object.mesh, static_cast<std::uint32_t>(meshes_.size()));
            if (isNew) meshes_.push_back(&object.mesh);
            instances_.push_back({known->second, here});
        }
        for (const ThreeMfPlace& component : object.components) place(component, home, here, depth + 1);
    }

    std::span<const std::byte> archive_;
    ReadJob job_;
    std::map<std::string, ZipEntry> entries_;
    std::map<std::string, ThreeMfPart> parts_;
    std::string root_;
    std::set<std::string> passedOver_;
    std::vector<const ImportedMesh*> meshes_;
    std::map<const ImportedMesh*, std::uint32_t> numbers_;
    std::vector<ImportedInstance> instances_;
    std::size_t places_ = 0;
};

}  // namespace

void sendThreeMf(std::span<const std::byte> file, ImportSender& sender) {
    // In this order: lib3mf follows components without bound.
    Model model(file);
    const ThreeMfVerdict verdict = checkThreeMf(file);
    if (verdict.given && (model.vertices() != verdict.vertices || model.triangles() != verdict.triangles))
        refuse("lib3mf finds " + counted(verdict.vertices, "vertex") + " and " +
                   counted(verdict.triangles, "triangle") + ", the file's text has " +
                   std::to_string(model.vertices()) + " and " + std::to_string(model.triangles()),
               "meshes without triangles of no area");
    for (const std::string& warning : verdict.warnings) sender.warning(warning);
    model.send(sender);
}

}  // namespace vestige::importer
