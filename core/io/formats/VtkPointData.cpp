#include "core/io/formats/VtkPointData.h"

#include <cctype>

#include "core/base/CleanText.h"

namespace vestige {

void VtkPointData::begin(bool ofPoints, std::size_t points) {
    count_ = values_.count(0);
    ofPoints_ = ofPoints;
    if (ofPoints && count_ != points)
        values_.refuse("POINT_DATA is for " + std::to_string(count_) + " points",
                       std::to_string(points) + " as in POINTS");
}

bool VtkPointData::read(const std::string& key) {
    const ScalarType colorType = values_.binary() ? ScalarType::uint8 : ScalarType::float32;
    if (key == "FIELD") {
        readFields();
    } else if (key == "LOOKUP_TABLE") {
        readLookupTable();
    } else if (key == "SCALARS") {
        readScalars();
    } else if (key == "COLOR_SCALARS") {
        const std::string name(values_.word());
        take({name, values_.count(), count_, colorType}, "colour");
    } else if (key == "TEXTURE_COORDINATES") {
        const std::string name(values_.word());
        const std::size_t components = values_.count();
        take({name, components, count_, values_.type()}, "");
    } else if (key == "NORMALS" || key == "VECTORS" || key == "TENSORS") {
        const std::string name(values_.word());
        const std::size_t components = key == "TENSORS" ? 9 : 3;
        take({name, components, count_, values_.type()}, key == "NORMALS" ? "normal" : "");
    } else {
        return false;
    }
    return true;
}

void VtkPointData::readLookupTable() {
    values_.word();
    const std::size_t size = values_.count();
    values_.skipArray(4 * size, values_.binary() ? ScalarType::uint8 : ScalarType::float32);
}

/// SCALARS name type [components], then a line LOOKUP_TABLE that may be missing.
void VtkPointData::readScalars() {
    Array array{std::string(values_.word()), 1, count_, values_.type()};
    TextScanner before = values_.place();
    std::string_view next = values_.word();
    if (next.size() == 1 && std::isdigit(static_cast<unsigned char>(next[0]))) {
        array.components = values_.countFrom(next);
        before = values_.place();
        next = values_.word();
    }
    if (equalsIgnoringCase(next, "lookup_table"))
        values_.word();
    else
        values_.returnTo(before);
    take(array, array.components >= 3 ? "colour" : "");
}

void VtkPointData::readFields() {
    values_.word();
    const std::size_t arrays = values_.count();
    for (std::size_t i = 0; i < arrays; ++i) {
        Array array;
        array.name = values_.word();
        if (array.name == "METADATA") {
            values_.skipMetadata();
            array.name = values_.word();
        }
        array.components = values_.count();
        array.tuples = values_.count(0);
        const std::string_view type = values_.word();
        if (!VtkValues::typeOfName(type))
            values_.refuse("an array's type is unknown", "float, double, int and such");
        array.type = *VtkValues::typeOfName(type);
        take(array, "");
    }
}

/// Where an array belongs; null when it is not kept. An array counts at its first place.
std::vector<double>* VtkPointData::targetOf(const Array& array, const std::string& kind) {
    if (!ofPoints_ || array.tuples != count_) return nullptr;
    const bool normals = kind == "normal" || equalsIgnoringCase(array.name, "normals");
    const bool colors = kind == "colour" || equalsIgnoringCase(array.name, "rgb");
    const PointField field = array.components == 1 ? fieldOfName(array.name) : PointField::none;
    std::vector<double>* target = nullptr;
    if (normals && array.components == 3) target = &normals_;
    if (colors && (array.components == 3 || array.components == 4)) target = &colors_;
    if (field == PointField::intensity) target = &intensity_;
    if (field == PointField::gpsTime) target = &time_;
    return target && target->empty() ? target : nullptr;
}

void VtkPointData::take(const Array& array, const std::string& kind) {
    values_.checkProduct(array.tuples, array.components);
    std::vector<double>* target = targetOf(array, kind);
    if (!target) {
        if (ofPoints_) job_.warn("not kept: " + cleanText(array.name));
        values_.skipArray(array.components * array.tuples, array.type);
        return;
    }
    values_.beginArray(array.components * array.tuples, array.type);
    const std::size_t kept = target == &colors_ ? 3 : array.components;
    target->reserve(kept * array.tuples);
    for (std::size_t i = 0; i < array.components * array.tuples; ++i) {
        const double value = values_.value(array.type);
        if (i % array.components < kept) target->push_back(value);
    }
    if (target == &colors_)
        colorDepth_ = array.type == ScalarType::uint8 ? ColorDepth::bytes : ColorDepth::guess;
}

void VtkPointData::dropPartial(std::size_t points) {
    if (normals_.size() != 3 * points) normals_.clear();
    if (colors_.size() != 3 * points) colors_.clear();
    if (intensity_.size() != points) intensity_.clear();
    if (time_.size() != points) time_.clear();
}

PointCloud VtkPointData::build(const std::vector<double>& coordinates) const {
    using enum PointField;
    std::vector<PointField> fields{x, y, z};
    if (!normals_.empty()) fields.insert(fields.end(), {normalX, normalY, normalZ});
    if (!colors_.empty()) fields.insert(fields.end(), {red, green, blue});
    if (!intensity_.empty()) fields.push_back(intensity);
    if (!time_.empty()) fields.push_back(gpsTime);
    const std::size_t points = coordinates.size() / 3;
    PointSink sink(fields, colorDepth_);
    sink.reserve(points);
    std::vector<double> row;
    for (std::size_t i = 0; i < points; ++i) {
        row.clear();
        const auto append = [&](const std::vector<double>& values, std::size_t components) {
            if (values.empty()) return;
            for (std::size_t k = 0; k < components; ++k) row.push_back(values[components * i + k]);
        };
        append(coordinates, 3);
        append(normals_, 3);
        append(colors_, 3);
        append(intensity_, 1);
        append(time_, 1);
        sink.add(row.data());
    }
    return std::move(sink).build();
}

}  // namespace vestige
