#include "app/cli/InfoText.h"

#include <nlohmann/json.hpp>

#include "app/cli/Session.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"

namespace vestige::cli {
namespace {

using nlohmann::json;

json triple(const Eigen::Vector3d& values) {
    return json::array({values.x(), values.y(), values.z()});
}

json optionalTriple(const std::optional<Eigen::Vector3d>& values) {
    return values ? triple(*values) : json();
}

json textOrNull(const std::string& text) {
    return text.empty() ? json() : json(text);
}

json scanJson(const ScanInfo& scan) {
    return {{"name", scan.name},
            {"guid", textOrNull(scan.guid)},
            {"points", scan.points},
            {"pose", rowMajor(scan.fileFromScan)},
            {"sensor_vendor", textOrNull(scan.sensorVendor)},
            {"sensor_model", textOrNull(scan.sensorModel)},
            {"sensor_serial", textOrNull(scan.sensorSerial)}};
}

json imageJson(const ImageInfo& image) {
    return {{"name", image.name},
            {"projection", image.projection},
            {"format", image.format},
            {"bytes", image.bytes},
            {"width", image.width},
            {"height", image.height},
            {"pose", image.fileFromImage ? json(rowMajor(*image.fileFromImage)) : json()}};
}

template <class Item>
json list(const std::vector<Item>& items, json (*one)(const Item&)) {
    json array = json::array();
    for (const Item& item : items) array.push_back(one(item));
    return array;
}

std::string text(const Eigen::Vector3d& values) {
    return exactText(values.x()) + " " + exactText(values.y()) + " " + exactText(values.z());
}

std::string unitText(double metresPerUnit) {
    const auto unit = lengthUnitOf(metresPerUnit);
    return (unit ? std::string(symbol(*unit)) + ", " : "") + exactText(metresPerUnit) + " m";
}

std::string scanText(const ScanInfo& scan) {
    std::string line = scan.name + ": " + std::to_string(scan.points) + " points, scanner at " +
                       text(scan.fileFromScan.translation());
    for (const std::string* part : {&scan.sensorVendor, &scan.sensorModel, &scan.sensorSerial})
        if (!part->empty()) line += (part == &scan.sensorVendor ? ", " : " ") + *part;
    return line;
}

std::string imageText(const ImageInfo& image) {
    return image.name + ": " + image.projection + " " + image.format + ", " + std::to_string(image.width) +
           " x " + std::to_string(image.height) + ", " + std::to_string(image.bytes) + " bytes";
}

}  // namespace

json infoJson(const FileInfo& info) {
    const auto unit = info.metresPerUnit ? lengthUnitOf(*info.metresPerUnit) : std::nullopt;
    json object{
        {"path", info.path.string()},
        {"format", info.format},
        {"version", info.version},
        {"points", info.points},
        {"triangles", info.triangles},
        {"bounds", info.bounds.empty()
                       ? json()
                       : json{{"min", triple(info.bounds.min)}, {"max", triple(info.bounds.max)}}},
        {"sha256", textOrNull(info.sha256)},
        {"scale", optionalTriple(info.scale)},
        {"offset", optionalTriple(info.offset)},
        {"crs", textOrNull(info.crs)},
        {"metres_per_unit", info.metresPerUnit ? json(*info.metresPerUnit) : json()},
        {"unit", unit ? json(symbol(*unit)) : json()},
        {"attributes", info.attributes},
        {"time_span", info.timeSpan ? json::array({info.timeSpan->first, info.timeSpan->second}) : json()},
        {"scans", list(info.scans, scanJson)},
        {"images", list(info.images, imageJson)},
        {"damage", textOrNull(info.damage)},
        {"warnings", info.warnings}};
    if (info.creationDayYear) {
        object["creation_day"] = info.creationDayYear->first;
        object["creation_year"] = info.creationDayYear->second;
    }
    if (!info.generatingSoftware.empty()) object["generating_software"] = info.generatingSoftware;
    return object;
}

void printInfo(const Session& session, const FileInfo& info) {
    const auto line = [&](const std::string& label, const std::string& value) {
        if (!value.empty()) session.print("  " + label + std::string(12 - label.size(), ' ') + value);
    };
    session.print(info.path.string());
    line("format", info.format + (info.version.empty() ? "" : " " + info.version));
    line("points", std::to_string(info.points));
    if (info.triangles > 0) line("triangles", std::to_string(info.triangles));
    if (!info.bounds.empty()) {
        line("minimum", text(info.bounds.min));
        line("maximum", text(info.bounds.max));
    }
    if (info.scale) line("scale", text(*info.scale));
    if (info.offset) line("offset", text(*info.offset));
    line("CRS", info.crs);
    if (info.metresPerUnit) line("unit", unitText(*info.metresPerUnit));
    std::string attributes;
    for (const std::string& name : info.attributes) attributes += (attributes.empty() ? "" : ", ") + name;
    line("attributes", attributes);
    if (info.timeSpan)
        line("time span", exactText(info.timeSpan->first) + " " + exactText(info.timeSpan->second));
    for (const ScanInfo& scan : info.scans) line("scan", scanText(scan));
    for (const ImageInfo& image : info.images) line("image", imageText(image));
    line("written by", info.generatingSoftware);
    line("SHA-256", info.sha256);
    line("damage", info.damage);
    for (const std::string& warning : info.warnings) line("warning", warning);
}

}  // namespace vestige::cli
