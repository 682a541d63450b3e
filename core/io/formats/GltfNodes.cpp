#include "core/io/formats/GltfNodes.h"

#include <nlohmann/json.hpp>

namespace vestige {
namespace {

using nlohmann::json;

/// glTF is y up: its (x, y, z) is (x, -z, y) here.
Eigen::Affine3d zUpFromYUp() {
    Eigen::Affine3d turn = Eigen::Affine3d::Identity();
    turn.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return turn;
}

class NodeWalk {
  public:
    explicit NodeWalk(const GltfJson& document)
        : document_(document), seen_(document.count("nodes"), false) {}

    std::vector<GltfMeshPlace> walk() {
        for (const std::uint64_t root : roots()) waiting_.emplace_back(root, zUpFromYUp());
        while (!waiting_.empty()) {
            const auto [node, outer] = waiting_.back();
            waiting_.pop_back();
            visit(node, outer);
        }
        if (document_.count("nodes") == 0)
            for (std::size_t mesh = 0; mesh < document_.count("meshes"); ++mesh)
                places_.push_back({mesh, zUpFromYUp()});
        return std::move(places_);
    }

  private:
    std::vector<std::uint64_t> roots() const {
        if (document_.count("scenes") > 0) {
            const std::uint64_t scene = document_.number(document_.document(), "scene", 0);
            std::vector<std::uint64_t> nodes =
                document_.numbers(document_.item("scenes", scene, "the document"), "nodes");
            return {nodes.rbegin(), nodes.rend()};
        }
        std::vector<bool> inner(seen_.size(), false);
        for (std::size_t i = 0; i < seen_.size(); ++i)
            for (const std::uint64_t child :
                 document_.numbers(document_.item("nodes", i, "a node"), "children"))
                if (child < inner.size()) inner[child] = true;
        std::vector<std::uint64_t> nodes;
        for (std::size_t i = seen_.size(); i-- > 0;)
            if (!inner[i]) nodes.push_back(i);
        return nodes;
    }

    void visit(std::uint64_t index, const Eigen::Affine3d& outer) {
        const json& node = document_.item("nodes", index, "a scene or node");
        if (seen_[index])
            document_.job().refuse(
                "node " + std::to_string(index) + " stands in the scene twice or holds itself",
                "a tree of nodes");
        seen_[index] = true;
        const Eigen::Affine3d here = outer * transformOf(node);
        if (const auto mesh = document_.find(node, "mesh")) places_.push_back({*mesh, here});
        const std::vector<std::uint64_t> children = document_.numbers(node, "children");
        // Two parents that share a child would let the list grow without end.
        if (waiting_.size() + children.size() > seen_.size())
            document_.job().refuse(
                "node " + std::to_string(index) + " has more children than there are nodes",
                "a tree of nodes");
        for (std::size_t i = children.size(); i-- > 0;) waiting_.emplace_back(children[i], here);
    }

    Eigen::Affine3d transformOf(const json& node) const {
        Eigen::Affine3d result = Eigen::Affine3d::Identity();
        if (const auto matrix = document_.reals(node, "matrix", 16)) {
            result.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix->data());
            if (result.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
                document_.job().refuse("the matrix of a node has another last row than 0 0 0 1",
                                       "an affine transform, column after column");
            return result;
        }
        if (const auto t = document_.reals(node, "translation", 3))
            result.translate(Eigen::Vector3d(t->data()));
        if (const auto r = document_.reals(node, "rotation", 4)) {
            const Eigen::Quaterniond turn((*r)[3], (*r)[0], (*r)[1], (*r)[2]);
            if (turn.norm() < 1e-6)
                document_.job().refuse("the rotation of a node is zero", "a quaternion of unit length");
            result.rotate(turn.normalized());
        }
        if (const auto s = document_.reals(node, "scale", 3)) result.scale(Eigen::Vector3d(s->data()));
        return result;
    }

    const GltfJson& document_;
    std::vector<bool> seen_;
    std::vector<std::pair<std::uint64_t, Eigen::Affine3d>> waiting_;
    std::vector<GltfMeshPlace> places_;
};

}  // namespace

std::vector<GltfMeshPlace> walkGltfNodes(const GltfJson& document) {
    return NodeWalk(document).walk();
}

}  // namespace vestige
