#include "core/io/formats/S3mbIndex.h"

#include <nlohmann/json.hpp>

#include "core/io/TextScanner.h"
#include "core/io/formats/JsonPart.h"
#include "core/io/formats/S3mbStream.h"

namespace vestige {
namespace {

using nlohmann::json;

std::string textAt(const json& object, const char* key) {
    if (!object.is_object()) return {};
    const auto found = object.find(key);
    if (found == object.end()) return {};
    return found->is_string() ? found->get<std::string>() : found->dump().substr(0, 200);
}

void takePosition(const json& tree, S3mbIndex& index, const ReadJob& job) {
    const auto position = tree.find("position");
    if (position == tree.end() || !position->is_object()) return;
    const auto point = position->find("point3D");
    if (point == position->end()) return;
    const char* axes[]{"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const auto value = point->is_object() ? point->find(axes[i]) : point->end();
        if (value == point->end() || !value->is_number())
            refuseS3mb(job, "the position of the index is no point", "the numbers x, y and z");
        index.position[i] = value->get<double>();
    }
    const std::string unit = textAt(*position, "unit");
    index.inDegrees = equalsIgnoringCase(unit, "degree");
    if (!index.inDegrees && !equalsIgnoringCase(unit, "meter"))
        refuseS3mb(job, "the position of the index has the unit '" + unit + "'", "Degree or Meter");
}

}  // namespace

S3mbIndex parseS3mbIndex(std::string_view text, const ReadJob& job) {
    if (trimmed(text).starts_with("<"))
        refuseS3mb(job, "this index is XML, of S3M before 3.0", "the JSON of S3M 3.0 or 3.01");
    const json tree = parseJsonObject(text, 0, {}, job);
    const std::string type = textAt(tree, "dataType");
    if (!equalsIgnoringCase(type, "pointcloud"))
        refuseS3mb(job, "the index is one of '" + type.substr(0, 40) + "'", "PointCloud");
    S3mbIndex index;
    index.version = textAt(tree, "version").substr(0, 20);
    const std::string lod = textAt(tree, "lodType");
    index.adds = equalsIgnoringCase(lod, "add");
    if (!index.adds && !equalsIgnoringCase(lod, "replace"))
        refuseS3mb(job, "the index has the lodType '" + lod.substr(0, 40) + "'", "Add or Replace");
    takePosition(tree, index, job);
    index.crs = textAt(tree, "crs").substr(0, 4000);
    const auto roots = tree.find("rootTiles");
    if (roots == tree.end() || !roots->is_array() || roots->empty())
        refuseS3mb(job, "the index names no tiles", "rootTiles");
    for (const json& root : *roots) index.rootTiles.push_back(textAt(root, "url"));
    return index;
}

}  // namespace vestige
