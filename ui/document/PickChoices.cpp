#include "ui/document/PickChoices.h"

#include <algorithm>
#include <iterator>

namespace vestige {

void PickChoices::nextSnap() {
    const auto* now = std::find(std::begin(kSnapModes), std::end(kSnapModes), snap_);
    const auto* next = now == std::end(kSnapModes) ? now : now + 1;
    setSnap(next == std::end(kSnapModes) ? kSnapModes[0] : *next);
}

QString snapText(SnapMode mode) {
    switch (mode) {
        case SnapMode::point:
            return PickChoices::tr("point");
        case SnapMode::plane:
            return PickChoices::tr("plane");
        case SnapMode::edge:
            return PickChoices::tr("edge");
        case SnapMode::corner:
            return PickChoices::tr("corner");
        case SnapMode::highest:
            return PickChoices::tr("highest");
        case SnapMode::lowest:
            return PickChoices::tr("lowest");
        case SnapMode::circle:
            return PickChoices::tr("circle");
        case SnapMode::centroid:
            return PickChoices::tr("centroid");
        case SnapMode::surface:
            return PickChoices::tr("surface");
    }
    return {};
}

QString snapPhrase(SnapMode mode) {
    switch (mode) {
        case SnapMode::point:
            return PickChoices::tr("at the nearest point");
        case SnapMode::plane:
            return PickChoices::tr("on the local plane");
        case SnapMode::edge:
            return PickChoices::tr("on an edge");
        case SnapMode::corner:
            return PickChoices::tr("at a corner");
        case SnapMode::highest:
            return PickChoices::tr("at the highest point");
        case SnapMode::lowest:
            return PickChoices::tr("at the lowest point");
        case SnapMode::circle:
            return PickChoices::tr("at a circle's centre");
        case SnapMode::centroid:
            return PickChoices::tr("at the centroid");
        case SnapMode::surface:
            return PickChoices::tr("on the surface seen");
    }
    return {};
}

}  // namespace vestige
