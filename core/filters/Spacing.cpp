#include "core/filters/Spacing.h"

#include <algorithm>
#include <memory>

#include "core/base/Numbers.h"
#include "core/base/Parallel.h"

namespace vestige {

Status checkRadius(double radius) {
    if (radius == 0 || (radius >= kLeastRadius && radius <= kMostRadius)) return {};
    return fail(ErrorCode::usage, "the radius " + exactText(radius) + " cannot be searched", "radius",
                "expected 1e-9 to 1e9, or 0 for automatic");
}

double medianSpacing(const Octree& octree) {
    const std::size_t size = octree.cloud().size();
    if (size < 2) return 0;
    std::vector<float> spacings(std::min<std::size_t>(size, 10000));
    parallelFor(spacings.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            spacings[i] = octree.localSpacing(static_cast<std::uint32_t>(i * size / spacings.size()));
    });
    const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return static_cast<double>(*middle);
}

double automaticRadius(const PointCloud& cloud) {
    // Borrows the cloud: the octree ends before this function does.
    const std::shared_ptr<const PointCloud> borrowed(std::shared_ptr<void>{}, &cloud);
    return 3 * medianSpacing(Octree(borrowed));
}

}  // namespace vestige
