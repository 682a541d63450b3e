#include "core/evaluation/Trajectory.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr double kOrthonormal = 1e-2;  // published poses have few digits

std::vector<std::string_view> words(std::string_view line) {
    constexpr std::string_view kBetween = " \t,;\r";
    std::vector<std::string_view> found;
    for (std::size_t begin = line.find_first_not_of(kBetween); begin != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
        found.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBetween, end);
    }
    return found;
}

Result<Pose> matrixPose(const std::vector<double>& values, std::size_t first) {
    std::array<double, 16> matrix{};
    for (std::size_t i = 0; i < 16; ++i) matrix[i] = values[first + i];
    return poseFromRowMajor(matrix, kOrthonormal);
}

Result<Pose> quaternionPose(const std::vector<double>& v) {
    const Eigen::Quaterniond turn(v[7], v[4], v[5], v[6]);
    if (std::abs(turn.norm() - 1) > kOrthonormal)
        return fail(ErrorCode::input, "the quaternion qx qy qz qw does not have length 1");
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    pose.translation() << v[1], v[2], v[3];
    return pose;
}

/// Column of T00 in an ASL header; nothing when the line is no header.
std::optional<std::size_t> matrixColumn(const std::vector<std::string_view>& header) {
    for (std::size_t i = 0; i < header.size(); ++i)
        if (header[i] == "T00") return i;
    return std::nullopt;
}

Result<Pose> poseOfLine(const std::vector<std::string_view>& cells, std::optional<std::size_t> column) {
    std::vector<double> values;
    for (const std::string_view cell : cells) {
        const auto value = parseReal(cell);
        if (!value || !std::isfinite(*value))
            return fail(ErrorCode::input, "'" + std::string(cell) + "' is not a number");
        values.push_back(*value);
    }
    if (column && values.size() >= *column + 16) return matrixPose(values, *column);
    if (!column && values.size() == 8) return quaternionPose(values);
    return fail(ErrorCode::input, "there are " + std::to_string(values.size()) + " numbers", {},
                column ? "expected a 4x4 matrix from column T00 on" : "expected t x y z qx qy qz qw");
}

}  // namespace

Result<std::vector<Pose>> readTrajectory(const std::filesystem::path& file) {
    const Result<std::string> text = readTextFile(file);
    if (!text) return fail(text.error());
    std::vector<Pose> poses;
    std::optional<std::size_t> column;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text->size();) {
        const std::size_t end = std::min(text->find('\n', begin), text->size());
        const auto cells = words(std::string_view(*text).substr(begin, end - begin));
        begin = end + 1;
        ++number;
        if (cells.empty() || cells[0].front() == '#') continue;
        if (poses.empty() && !column && (column = matrixColumn(cells))) continue;
        Result<Pose> pose = poseOfLine(cells, column);
        if (!pose) {
            pose.error().place = file.string() + " line " + std::to_string(number);
            return fail(pose.error());
        }
        poses.push_back(*pose);
    }
    if (poses.size() < 2)
        return fail(ErrorCode::input, "there are fewer than two poses", file.string(),
                    "expected an ASL pose CSV, or lines t x y z qx qy qz qw");
    return poses;
}

}  // namespace vestige
