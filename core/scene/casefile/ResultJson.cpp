#include <array>
#include <nlohmann/json.hpp>

#include "core/registration/RegistrationJson.h"
#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

constexpr std::array<std::pair<StopReason, const char*>, 5> kStopReasons{
    {{StopReason::gradient, "gradient"},
     {StopReason::step, "step"},
     {StopReason::predictedDecrease, "predicted-decrease"},
     {StopReason::iterationLimit, "iteration-limit"},
     {StopReason::noOverlap, "no-overlap"}}};

constexpr std::array kVerdicts{Verdict::accepted, Verdict::doubtful, Verdict::failed, Verdict::ambiguous};

Verdict readVerdict(const JsonCursor& verdict) {
    const std::string text = verdict.text();
    for (const Verdict known : kVerdicts)
        if (describe(known) == text) return known;
    verdict.reject("'" + text + "' is no verdict", "expected accepted, doubtful, failed or ambiguous");
}

std::string stopText(StopReason reason) {
    for (const auto& [value, text] : kStopReasons)
        if (value == reason) return text;
    return {};
}

StopReason readStop(const JsonCursor& stop) {
    const std::string text = stop.text();
    for (const auto& [value, known] : kStopReasons)
        if (known == text) return value;
    stop.reject("'" + text + "' is not a reason to stop",
                "expected gradient, step, predicted-decrease, "
                "iteration-limit or no-overlap");
}

/// A pose of ours, bit for bit: it is checked as any other but not made orthonormal anew.
Pose readExactPose(const JsonCursor& cursor) {
    Pose pose = readPose(cursor);
    const auto numbers = cursor.elements();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            pose.matrix()(row, column) = numbers[static_cast<std::size_t>(4 * row + column)].real();
    return pose;
}

Similarity readSimilarity(const JsonCursor& cursor) {
    return {readExactPose(cursor.at("pose")), cursor.at("scale").realAbove0()};
}

}  // namespace

nlohmann::ordered_json poseJson(const Pose& pose) {
    return rowMajor(pose);
}

Pose readPose(const JsonCursor& cursor) {
    const auto numbers = cursor.elements(16, "16 numbers, the 4x4 matrix row by row");
    std::array<double, 16> matrix{};
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = numbers[i].real();
    const auto pose = poseFromRowMajor(matrix);
    if (!pose) cursor.reject(pose.error().message, pose.error().hint);
    return *pose;
}

nlohmann::ordered_json resultJson(const RegistrationResult& result) {
    nlohmann::ordered_json levels = nlohmann::ordered_json::array();
    for (const auto& level : result.levels)
        levels.push_back({{"voxel_m", level.voxel_m},
                          {"iterations", level.iterations},
                          {"score", level.score},
                          {"stop", stopText(level.stop)},
                          {"pose", poseJson(level.targetFromSource)}});
    nlohmann::ordered_json candidates = nlohmann::ordered_json::array();
    for (const PoseCandidate& one : result.candidates)
        candidates.push_back({{"pose", poseJson(one.targetFromSource.pose)},
                              {"scale", one.targetFromSource.scale},
                              {"score", one.score}});
    nlohmann::ordered_json json{
        {"method", result.method},
        {"converged", result.converged},
        {"iterations", result.iterations},
        {"seconds", result.seconds},
        {"pose", poseJson(result.targetFromSource.pose)},
        {"scale", result.targetFromSource.scale},
        {"rmse_m", result.rmse_m},
        {"overlap", result.overlap},
        {"target_overlap", result.targetOverlap},
        {"inlier_distance_m", result.inlierDistance_m},
        {"voxel_schedule_m", result.voxelSchedule_m},
        {"levels", levels},
        {"notes", result.notes},
        {"verdict", std::string(describe(result.verdict))},
        {"reasons", result.reasons},
        {"candidates", std::move(candidates)},
        {"initial", {{"pose", poseJson(result.initial.pose)}, {"scale", result.initial.scale}}}};
    if (result.quality) json["quality"] = qualityJson(*result.quality);
    if (!result.via.empty()) json["via"] = result.via;
    return json;
}

RegistrationResult readResult(const JsonCursor& cursor) {
    constexpr std::int64_t kMostIterations = 1000000000;
    const auto number = [](const JsonCursor& object, std::string_view key) {
        const auto member = object.find(key);
        return member ? member->real() : std::numeric_limits<double>::quiet_NaN();
    };
    RegistrationResult result;
    result.method = cursor.at("method").text();
    result.targetFromSource = readSimilarity(cursor);
    if (const auto flag = cursor.find("converged")) result.converged = flag->boolean();
    if (const auto count = cursor.find("iterations"))
        result.iterations = static_cast<int>(count->integer(0, kMostIterations));
    result.seconds = number(cursor, "seconds");
    result.rmse_m = number(cursor, "rmse_m");
    result.overlap = number(cursor, "overlap");
    result.targetOverlap = number(cursor, "target_overlap");
    result.inlierDistance_m = number(cursor, "inlier_distance_m");
    if (const auto sizes = cursor.find("voxel_schedule_m"))
        for (const auto& size : sizes->elements()) result.voxelSchedule_m.push_back(size.realAbove0());
    if (const auto levels = cursor.find("levels"))
        for (const auto& level : levels->elements())
            result.levels.push_back({level.at("voxel_m").real(),
                                     static_cast<int>(level.at("iterations").integer(0, kMostIterations)),
                                     number(level, "score"), readStop(level.at("stop")),
                                     readExactPose(level.at("pose"))});
    if (const auto notes = cursor.find("notes"))
        for (const auto& note : notes->elements()) result.notes.push_back(note.text());
    if (const auto verdict = cursor.find("verdict")) result.verdict = readVerdict(*verdict);
    if (const auto reasons = cursor.find("reasons"))
        for (const auto& reason : reasons->elements()) result.reasons.push_back(reason.text());
    if (const auto candidates = cursor.find("candidates"))
        for (const auto& one : candidates->elements())
            result.candidates.push_back({readSimilarity(one), number(one, "score")});
    if (const auto quality = cursor.find("quality")) result.quality = readQuality(*quality);
    if (const auto initial = cursor.find("initial")) result.initial = readSimilarity(*initial);
    if (const auto via = cursor.find("via"))
        for (const auto& layer : via->elements()) result.via.push_back(layer.name());
    return result;
}

bool sameText(const RegistrationResult& a, const RegistrationResult& b) {
    return resultJson(a) == resultJson(b);
}

}  // namespace vestige
