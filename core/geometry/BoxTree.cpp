#include "core/geometry/BoxTree.h"

#include "core/base/Parallel.h"

namespace vestige {

BoxTree::BoxTree(std::span<const FloatBox> leaves) {
    std::vector<FloatBox> boxes(leaves.begin(), leaves.end());
    while (!boxes.empty() && (levels_.empty() || levels_.back().size() > 1)) {
        std::vector<Node>& nodes = levels_.emplace_back((boxes.size() + 7) / 8);
        std::vector<FloatBox> above(nodes.size());
        parallelFor(nodes.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t child = 0; child < 8; ++child) {
                    const FloatBox box = 8 * i + child < boxes.size() ? boxes[8 * i + child] : FloatBox();
                    above[i].add(box);
                    for (int axis = 0; axis < 3; ++axis) {
                        nodes[i].min[static_cast<std::size_t>(axis)][child] = box.min[axis];
                        nodes[i].max[static_cast<std::size_t>(axis)][child] = box.max[axis];
                    }
                }
        });
        boxes = std::move(above);
    }
}

}  // namespace vestige
