#include "ui/actions/KindTools.h"

namespace vestige {

const std::vector<std::pair<const char*, MeasurementKind>>& kindTools() {
    using Kind = MeasurementKind;
    static const std::vector<std::pair<const char*, Kind>> all{{"tool.horizontal", Kind::horizontal},
                                                               {"tool.vertical", Kind::vertical},
                                                               {"tool.point-plane", Kind::pointToPlane},
                                                               {"tool.plane-plane", Kind::planeToPlane},
                                                               {"tool.angle", Kind::angle},
                                                               {"tool.polyline", Kind::polyline},
                                                               {"tool.arc", Kind::arc},
                                                               {"tool.area", Kind::area},
                                                               {"tool.circle", Kind::circle},
                                                               {"tool.box", Kind::box},
                                                               {"tool.profile", Kind::profile},
                                                               {"tool.crush", Kind::crush},
                                                               {"tool.volume", Kind::volume}};
    return all;
}

std::string kindIcon(MeasurementKind kind) {
    // Icons are called as the actions are.
    for (const auto& [id, each] : kindTools())
        if (each == kind) return "kind-" + std::string(id).substr(std::string("tool.").size());
    return "distance";
}

}  // namespace vestige
