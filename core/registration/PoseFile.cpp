#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/registration/InitialPose.h"

namespace vestige {
namespace {

using nlohmann::json;

Result<Similarity> similarityOf(const json& object, const std::string& place) {
    if (!object.is_object() || !object.contains("pose"))
        return fail(ErrorCode::input, "there is no field 'pose'", place,
                    R"(expected {"pose": [16 numbers], "scale": metres per unit})");
    const json& numbers = object["pose"];
    if (!numbers.is_array() || numbers.size() != 16)
        return fail(ErrorCode::input, "the field 'pose' is not a list of 16 numbers", place,
                    "expected a 4x4 matrix row by row");
    std::array<double, 16> matrix{};
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        if (!numbers[i].is_number())
            return fail(ErrorCode::input, "number " + std::to_string(i + 1) + " of 'pose' is not a number",
                        place);
        matrix[i] = numbers[i].get<double>();
    }
    const Result<Pose> pose = poseFromRowMajor(matrix);
    if (!pose)
        return fail(ErrorCode::input, pose.error().message, place + " field 'pose'", pose.error().hint);
    Similarity similarity{*pose, 1};
    if (object.contains("scale")) {
        const json& scale = object["scale"];
        if (!scale.is_number() || !(scale.get<double>() > 0) || !std::isfinite(scale.get<double>()))
            return fail(ErrorCode::input, "the field 'scale' is not a number above 0", place,
                        "expected metres per unit of the source, 0.001 for millimetres");
        similarity.scale = scale.get<double>();
    }
    return similarity;
}

}  // namespace

Result<Similarity> readPoseFile(const std::filesystem::path& file) {
    const Result<std::string> text = readTextFile(file, 1 << 20);
    if (!text) return fail(text.error());
    const json object = json::parse(*text, nullptr, false);
    if (object.is_discarded())
        return fail(ErrorCode::input, "this is no JSON", file.string(),
                    R"(expected {"pose": [16 numbers], "scale": metres per unit})");
    return similarityOf(object, file.string());
}

std::string poseFileText(const Similarity& targetFromSource) {
    const json object{{"pose", rowMajor(targetFromSource.pose)}, {"scale", targetFromSource.scale}};
    return object.dump(2) + "\n";
}

Status writePoseFile(const std::filesystem::path& file, const Similarity& targetFromSource) {
    return writeTextFile(file, poseFileText(targetFromSource));
}

}  // namespace vestige
