#include "core/registration/global/ConsistentMatches.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/Parallel.h"
#include "core/geometry/Pose.h"

namespace vestige {
namespace {

constexpr std::size_t kRowGrain = 32;
constexpr float kNormalTolerance = 0.25F;  // of cosines
constexpr std::size_t kMembers = 24;       // matches that a seed's pose is made of
constexpr std::uint32_t kLeastSupport = 4;

/// Which matches agree with which, a row of bits for each.
class Agreement {
  public:
    explicit Agreement(std::size_t count) : words_((count + 63) / 64), bits_(count * words_, 0) {}
    std::span<std::uint64_t> row(std::size_t i) { return {bits_.data() + i * words_, words_}; }
    std::span<const std::uint64_t> row(std::size_t i) const { return {bits_.data() + i * words_, words_}; }
    std::uint32_t degree(std::size_t i) const {
        std::uint32_t count = 0;
        for (const std::uint64_t word : row(i)) count += static_cast<std::uint32_t>(std::popcount(word));
        return count;
    }
    std::uint32_t common(std::size_t i, std::size_t j) const {
        std::uint32_t count = 0;
        const auto a = row(i);
        const auto b = row(j);
        for (std::size_t w = 0; w < words_; ++w)
            count += static_cast<std::uint32_t>(std::popcount(a[w] & b[w]));
        return count;
    }

  private:
    std::size_t words_;
    std::vector<std::uint64_t> bits_;
};

struct MatchedPoints {
    std::vector<Eigen::Vector3f> source, target, sourceNormal, targetNormal;
};

MatchedPoints pointsOf(const Surfels& target, const Surfels& source, std::span<const SurfelMatch> matches) {
    MatchedPoints points;
    for (const SurfelMatch& match : matches) {
        points.source.push_back(source.points[match.source]);
        points.target.push_back(target.points[match.target]);
        points.sourceNormal.push_back(source.normals[match.source]);
        points.targetNormal.push_back(target.normals[match.target]);
    }
    return points;
}

bool alike(float a, float b) {
    return std::abs(std::abs(a) - std::abs(b)) < kNormalTolerance;
}

/// Points as three arrays, padded to whole steps of eight with points far away from everything.
struct PointColumns {
    explicit PointColumns(const std::vector<Eigen::Vector3f>& points) : size((points.size() + 7) / 8 * 8) {
        for (int axis = 0; axis < 3; ++axis) {
            along[axis].assign(size, std::numeric_limits<float>::infinity());
            for (std::size_t i = 0; i < points.size(); ++i) along[axis][i] = points[i][axis];
        }
    }
    /// Distances of the points at ... at + 7 from `from`.
    __m256 distances(std::size_t at, const Eigen::Vector3f& from) const {
        const __m256 x = _mm256_sub_ps(_mm256_loadu_ps(along[0].data() + at), _mm256_set1_ps(from.x()));
        const __m256 y = _mm256_sub_ps(_mm256_loadu_ps(along[1].data() + at), _mm256_set1_ps(from.y()));
        const __m256 z = _mm256_sub_ps(_mm256_loadu_ps(along[2].data() + at), _mm256_set1_ps(from.z()));
        return _mm256_sqrt_ps(_mm256_fmadd_ps(z, z, _mm256_fmadd_ps(y, y, _mm256_mul_ps(x, x))));
    }
    std::array<std::vector<float>, 3> along;
    std::size_t size;
};

/// Whether the angles of two matches' normals, to each other and to the line between them, are alike.
bool anglesAgree(const MatchedPoints& points, std::size_t i, std::size_t j) {
    const Eigen::Vector3f d = (points.source[j] - points.source[i]).normalized();
    const Eigen::Vector3f e = (points.target[j] - points.target[i]).normalized();
    return alike(points.sourceNormal[i].dot(points.sourceNormal[j]),
                 points.targetNormal[i].dot(points.targetNormal[j])) &&
           alike(points.sourceNormal[i].dot(d), points.targetNormal[i].dot(e)) &&
           alike(points.sourceNormal[j].dot(d), points.targetNormal[j].dot(e));
}

Agreement agreements(const MatchedPoints& points, const ConsistencyOptions& options) {
    const std::size_t count = points.source.size();
    Agreement agreement(count);
    const PointColumns source(points.source);
    const PointColumns target(points.target);
    const __m256 tolerance = _mm256_set1_ps(static_cast<float>(options.tolerance_m));
    const __m256 least = _mm256_set1_ps(static_cast<float>(options.leastDistance_m));
    const __m256 sign = _mm256_set1_ps(-0.0F);
    parallelFor(count, kRowGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto row = agreement.row(i);
            for (std::size_t at = 0; at < source.size; at += 8) {
                const __m256 a = source.distances(at, points.source[i]);
                const __m256 b = target.distances(at, points.target[i]);
                const __m256 alikeLong =
                    _mm256_cmp_ps(_mm256_andnot_ps(sign, _mm256_sub_ps(a, b)), tolerance, _CMP_LT_OQ);
                const __m256 longEnough = _mm256_cmp_ps(_mm256_min_ps(a, b), least, _CMP_GE_OQ);
                auto mask = static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(alikeLong, longEnough)));
                for (; mask != 0; mask &= mask - 1) {
                    const std::size_t j = at + static_cast<std::size_t>(std::countr_zero(mask));
                    if (anglesAgree(points, i, j)) row[j / 64] |= std::uint64_t{1} << (j % 64);
                }
            }
        }
    });
    return agreement;
}

/// The matches that agree with the seed, those with the most agreeing ones in common first.
std::vector<std::uint32_t> membersOf(std::uint32_t seed, const Agreement& agreement) {
    struct Member {
        std::uint32_t match;
        std::uint32_t common;
    };
    std::vector<Member> members;
    const auto row = agreement.row(seed);
    for (std::size_t w = 0; w < row.size(); ++w)
        for (std::uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
            const auto match =
                static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(bits)));
            members.push_back({match, agreement.common(seed, match)});
        }
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
        return a.common != b.common ? a.common > b.common : a.match < b.match;
    });
    std::vector<std::uint32_t> chosen{seed};
    for (const Member& member : members) {
        if (chosen.size() > kMembers) break;
        chosen.push_back(member.match);
    }
    return chosen;
}

Eigen::Isometry3d alignMatches(const MatchedPoints& points, std::span<const std::uint32_t> members) {
    WeightedAlignment alignment;
    for (const std::uint32_t i : members)
        alignment.add(points.source[i].cast<double>(), points.target[i].cast<double>());
    return alignment.pose();
}

std::vector<std::uint32_t> explained(const MatchedPoints& points, const Eigen::Isometry3d& pose,
                                     double tolerance) {
    constexpr float kNormals = 0.7F;
    const Eigen::Isometry3f p = pose.cast<float>();
    const auto limit = static_cast<float>(tolerance * tolerance);
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < points.source.size(); ++i)
        if ((p * points.source[i] - points.target[i]).squaredNorm() < limit &&
            std::abs((p.linear() * points.sourceNormal[i]).dot(points.targetNormal[i])) > kNormals)
            found.push_back(i);
    return found;
}

}  // namespace

void WeightedAlignment::add(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double weight) {
    weight_ += weight;
    from_ += weight * from;
    to_ += weight * to;
    products_ += weight * to * from.transpose();
}

Eigen::Isometry3d WeightedAlignment::pose() const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    if (!(weight_ > 0)) return pose;
    pose.linear() = nearestRotation(products_ - to_ * from_.transpose() / weight_);
    pose.translation() = (to_ - pose.linear() * from_) / weight_;
    return pose;
}

std::vector<PoseProposal> consistentPoses(const Surfels& target, const Surfels& source,
                                          std::span<const SurfelMatch> matches,
                                          const ConsistencyOptions& options) {
    const MatchedPoints points = pointsOf(target, source, matches);
    const Agreement agreement = agreements(points, options);
    std::vector<std::uint32_t> degree(matches.size());
    for (std::size_t i = 0; i < degree.size(); ++i) degree[i] = agreement.degree(i);
    std::vector<std::uint32_t> order(matches.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return degree[a] != degree[b] ? degree[a] > degree[b] : a < b;
    });
    std::vector<bool> used(matches.size(), false);
    std::vector<PoseProposal> proposals;
    for (const std::uint32_t seed : order) {
        if (proposals.size() >= options.proposals || degree[seed] < kLeastSupport) break;
        if (used[seed]) continue;
        used[seed] = true;
        const std::vector<std::uint32_t> members = membersOf(seed, agreement);
        Eigen::Isometry3d pose = alignMatches(points, members);
        std::vector<std::uint32_t> inliers = explained(points, pose, 2 * options.tolerance_m);
        if (inliers.size() < kLeastSupport) continue;
        pose = alignMatches(points, inliers);
        inliers = explained(points, pose, 1.5 * options.tolerance_m);
        for (const std::uint32_t i : inliers) used[i] = true;
        proposals.push_back({pose, static_cast<std::uint32_t>(inliers.size())});
    }
    return proposals;
}

}  // namespace vestige
