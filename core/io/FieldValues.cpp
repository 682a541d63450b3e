#include "core/io/FieldValues.h"

#include "core/base/Numbers.h"

namespace vestige {

void appendValue(PointAttributes& attributes, PointField field, double value) {
    switch (field) {
        case PointField::intensity:
            attributes.intensity.push_back(toFloat(value));
            break;
        case PointField::classification:
            attributes.classification.push_back(nearestInteger<std::uint8_t>(value));
            break;
        case PointField::gpsTime:
            attributes.gpsTime.push_back(value);
            break;
        case PointField::pointSource:
            attributes.pointSource.push_back(nearestInteger<std::uint16_t>(value));
            break;
        case PointField::returnNumber:
            attributes.returnNumber.push_back(nearestInteger<std::uint8_t>(value));
            break;
        case PointField::returnCount:
            attributes.returnCount.push_back(nearestInteger<std::uint8_t>(value));
            break;
        default:
            break;
    }
}

}  // namespace vestige
