#include "core/pipeline/FreeDirections.h"

#include <Eigen/Geometry>

namespace vestige {
namespace {

constexpr double kLeastReach_m = 0.05;
constexpr double kArcHalf_rad = 1.2;
constexpr int kArcSteps = 32;

}  // namespace

std::vector<ViewArrow> freeDirectionArrows(const RegistrationQuality& quality) {
    std::vector<ViewArrow> arrows;
    const Eigen::Vector3d& middle = quality.uncertainty.pivot_m;
    const double reach = std::max(quality.radius_m, kLeastReach_m);
    for (const ObservedDirection& observed : quality.directions) {
        const Eigen::Vector3d slide = observed.direction.head<3>();
        const Eigen::Vector3d turn = observed.direction.tail<3>();
        if (!observed.free || observed.direction.norm() == 0) continue;
        ViewArrow arrow{{}, observed.words};
        if (slide.norm() >= turn.norm()) {
            const Eigen::Vector3d along = slide.normalized();
            arrow.path = {middle - 2 * reach * along, middle + 2 * reach * along};
        } else {
            const Eigen::Vector3d axis = turn.normalized();
            const Eigen::Vector3d arm = reach * axis.unitOrthogonal();
            for (int i = -kArcSteps; i <= kArcSteps; ++i)
                arrow.path.push_back(middle + Eigen::AngleAxisd(kArcHalf_rad * i / kArcSteps, axis) * arm);
        }
        arrows.push_back(std::move(arrow));
    }
    return arrows;
}

}  // namespace vestige
