#pragma once

#include <string>
#include <vector>

namespace vestige {

/// What points have beside coordinates.
struct PresentAttributes {
    bool intensity = false;
    bool color = false;
    bool classification = false;
    bool gpsTime = false;
    bool normals = false;
    bool pointSource = false;
    bool returnNumber = false;
    bool returnCount = false;
};

/// As FileInfo::attributes has them: always the same names, in the same order.
std::vector<std::string> attributeNames(const PresentAttributes& present);

}  // namespace vestige
