#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/measurement/kinds/KindInput.h"
#include "core/measurement/kinds/SmallestRectangle.h"

namespace vestige {

Result<KindValues> boxValues(const KindInput& input) {
    std::vector<Eigen::Vector2d> plan;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const KindEnd& end : input.ends) {
        plan.emplace_back((end.position - input.at(0)).head<2>());
        lowest = std::min(lowest, end.position.z());
        highest = std::max(highest, end.position.z());
    }
    const auto corners = smallestRectangle(plan);
    if (!corners) return fail(ErrorCode::input, "the points of the box lie on one line in plan");
    const Eigen::Vector2d sides(((*corners)[1] - (*corners)[0]).norm(),
                                ((*corners)[2] - (*corners)[1]).norm());
    const double length = sides.maxCoeff(), width = sides.minCoeff(), height = highest - lowest;
    return KindValues{{{"length", "Length of the box", QuantityUnit::metre, length},
                       {"width", "Width of the box", QuantityUnit::metre, width},
                       {"height", "Height of the box", QuantityUnit::metre, height},
                       {"diagonal", "Diagonal of the box", QuantityUnit::metre,
                        std::sqrt(length * length + width * width + height * height)},
                       {"volume", "Volume of the box", QuantityUnit::cubicMetre, length * width * height}}};
}

}  // namespace vestige
