#include "core/io/AttributeNames.h"

namespace vestige {

std::vector<std::string> attributeNames(const PresentAttributes& present) {
    std::vector<std::string> names;
    const auto name = [&](bool isPresent, const char* text) {
        if (isPresent) names.emplace_back(text);
    };
    name(present.intensity, "intensity");
    name(present.color, "color");
    name(present.classification, "classification");
    name(present.gpsTime, "gps_time");
    name(present.normals, "normals");
    name(present.pointSource, "point_source");
    name(present.returnNumber, "return_number");
    name(present.returnCount, "return_count");
    return names;
}

}  // namespace vestige
