#include "core/evaluation/Trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/base/AtomicFile.h"
#include "core/base/CleanText.h"
#include "core/base/Numbers.h"
#include "core/io/Coordinates.h"

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

/// The columns of an ASL header.
struct AslColumns {
    std::array<std::size_t, 16> matrix{};
    std::optional<std::size_t> id;
    std::size_t count = 0;
};

bool isMatrixName(std::string_view word) {
    return word.size() == 3 && word[0] == 'T' && word[1] >= '0' && word[1] <= '3' && word[2] >= '0' &&
           word[2] <= '3';
}

bool isAslHeader(const std::vector<std::string_view>& line) {
    return std::any_of(line.begin(), line.end(), isMatrixName);
}

Result<AslColumns> aslColumns(const std::vector<std::string_view>& header) {
    AslColumns columns;
    columns.count = header.size();
    for (std::size_t i = 0; i < 16; ++i) {
        const char name[] = {'T', static_cast<char>('0' + i / 4), static_cast<char>('0' + i % 4), 0};
        const auto found = std::find(header.begin(), header.end(), std::string_view(name));
        if (found == header.end())
            return fail(ErrorCode::input, std::string("the header has no column ") + name, {},
                        "expected poseId,timestamp,T00,T01,...,T33");
        columns.matrix[i] = static_cast<std::size_t>(found - header.begin());
    }
    const auto id = std::find(header.begin(), header.end(), std::string_view("poseId"));
    if (id != header.end()) columns.id = static_cast<std::size_t>(id - header.begin());
    return columns;
}

Result<std::vector<double>> numbers(const std::vector<std::string_view>& cells) {
    std::vector<double> values;
    for (const std::string_view cell : cells) {
        const auto value = parseReal(cell);
        if (!value || !std::isfinite(*value))
            return fail(ErrorCode::input, "'" + cleanText(cell) + "' is not a finite number");
        values.push_back(*value);
    }
    return values;
}

Result<Pose> quaternionPose(const std::vector<double>& v) {
    if (v.size() != 8)
        return fail(ErrorCode::input, "there are " + std::to_string(v.size()) + " numbers", {},
                    "expected t x y z qx qy qz qw, or the header of an ASL pose file before");
    const Eigen::Quaterniond turn(v[7], v[4], v[5], v[6]);
    if (std::abs(turn.norm() - 1) > kOrthonormal)
        return fail(ErrorCode::input, "the quaternion qx qy qz qw does not have length 1");
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    pose.translation() << v[1], v[2], v[3];
    return pose;
}

Result<Pose> matrixPose(const std::vector<double>& v, const AslColumns& columns) {
    if (v.size() != columns.count)
        return fail(ErrorCode::input, "there are " + std::to_string(v.size()) + " numbers", {},
                    "expected " + std::to_string(columns.count) + ", as the header names");
    std::array<double, 16> matrix{};
    for (std::size_t i = 0; i < 16; ++i) matrix[i] = v[columns.matrix[i]];
    return poseFromRowMajor(matrix, kOrthonormal);
}

/// Reads a file line by line into a trajectory.
class Reader {
  public:
    Status take(const std::vector<std::string_view>& cells) {
        if (trajectory_.poses.empty() && !columns_ && isAslHeader(cells)) {
            const Result<AslColumns> columns = aslColumns(cells);
            if (!columns) return fail(columns.error());
            columns_ = *columns;
            return {};
        }
        const Result<std::vector<double>> values = numbers(cells);
        if (!values) return fail(values.error());
        const Result<Pose> pose = columns_ ? matrixPose(*values, *columns_) : quaternionPose(*values);
        if (!pose) return fail(pose.error());
        if (!isUsable(pose->translation()))
            return fail(ErrorCode::input, "the place is farther from 0 than any on Earth", {},
                        "expected metres up to 1e10");
        trajectory_.poses.push_back(*pose);
        return columns_ && columns_->id ? takeId((*values)[*columns_->id]) : Status{};
    }
    Trajectory finish() { return std::move(trajectory_); }

  private:
    Status takeId(double value) {
        if (value != std::floor(value) || std::abs(value) > 1e9)
            return fail(ErrorCode::input, "poseId " + exactText(value) + " is not a whole number");
        const auto id = static_cast<std::int64_t>(value);
        if (!ids_.insert(id).second)
            return fail(ErrorCode::input, "poseId " + std::to_string(id) + " is there twice");
        trajectory_.ids.push_back(id);
        return {};
    }

    std::optional<AslColumns> columns_;
    std::set<std::int64_t> ids_;
    Trajectory trajectory_;
};

}  // namespace

Result<Trajectory> readTrajectory(const std::filesystem::path& file) {
    constexpr std::size_t kLargestFile = std::size_t{256} << 20;  // a million poses
    const Result<std::string> text = readTextFile(file, kLargestFile);
    if (!text) return fail(text.error());
    Reader reader;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text->size();) {
        const std::size_t end = std::min(text->find('\n', begin), text->size());
        const auto cells = words(std::string_view(*text).substr(begin, end - begin));
        begin = end + 1;
        ++number;
        if (cells.empty() || cells[0].front() == '#') continue;
        if (const Status taken = reader.take(cells); !taken) {
            Error error = taken.error();
            error.place = file.string() + " line " + std::to_string(number);
            return fail(std::move(error));
        }
    }
    Trajectory trajectory = reader.finish();
    if (trajectory.poses.size() < 2)
        return fail(ErrorCode::input, "there are fewer than two poses", file.string(),
                    "expected an ASL pose CSV, or lines t x y z qx qy qz qw");
    return trajectory;
}

}  // namespace vestige
