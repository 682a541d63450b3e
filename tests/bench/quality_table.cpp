// The figures of docs/decisions/0009: run by hand (ninja quality_table && bin/quality_table).
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/registration/Register.h"
#include "core/simulation/TripodPair.h"

namespace vestige {
namespace {

constexpr double kChiSquare95 = 12.592;

TripodSceneKind kindOf(std::uint64_t tenth) {
    return tenth < 7 ? TripodSceneKind::street : tenth < 9 ? TripodSceneKind::hall : TripodSceneKind::field;
}

TripodPairOptions randomPair(std::uint64_t seed, std::size_t points) {
    Random random(seed, 77);
    TripodPairOptions options;
    options.points = points;
    options.seed = seed;
    options.scene.kind = kindOf(random.below(10));
    options.scene.seed = seed;
    options.distance_m = random.uniform(3, 14);
    options.yaw_deg = random.uniform(-70, 70);
    options.rangeNoise_m = random.uniform() < 0.7 ? 0.003 : 0.01;
    return options;
}

Vector6d errorOf(const Pose& found, const Pose& truth, const Eigen::Vector3d& pivot) {
    const Pose move = truth * found.inverse();
    const Eigen::AngleAxisd turn(move.linear());
    Vector6d error;
    error << move * pivot - pivot, turn.angle() * turn.axis();
    return error;
}

bool right(const Pose& found, const Pose& truth) {
    const Pose move = truth * found.inverse();
    return (found.translation() - truth.translation()).norm() < 0.05 &&
           rotationAngle(move.linear()) < radians(0.5);
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0
                          : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Result<RegistrationResult> registered(const TripodPair& pair, const Pose& start, int restarts) {
    ParameterSet parameters{registrationParameters()};
    if (!parameters.set("restarts", std::int64_t{restarts})) std::abort();
    return attemptRegistration({pair.target, {}}, {pair.source, {}}, {start, 1}, parameters);
}

/// How often the 95 % ellipsoid holds the truth, and how large it is against the errors.
void coverage(int trials, std::uint64_t seed, std::size_t points) {
    std::vector<double> distances;
    std::vector<double> ratios;
    for (int i = 0; i < trials; ++i) {
        const std::uint64_t one = seed + static_cast<std::uint64_t>(i);
        const TripodPair pair = simulateTripodPair(randomPair(one, points));
        const Pose truth = pair.targetFromSource();
        const auto result = registered(pair, wrongPose(truth, 0.5, 4, one), 0);
        if (!result || !right(result->targetFromSource.pose, truth)) {
            std::printf("seed %llu: no right pose\n", static_cast<unsigned long long>(one));
            continue;
        }
        const PoseUncertainty& uncertainty = result->quality->uncertainty;
        const Vector6d error = errorOf(result->targetFromSource.pose, truth, uncertainty.pivot_m);
        distances.push_back(error.dot(uncertainty.covariance.ldlt().solve(error)));
        Vector6d metres;
        metres << 1, 1, 1, Eigen::Vector3d::Constant(result->quality->radius_m);
        const Matrix6d scaled = metres.asDiagonal() * uncertainty.covariance * metres.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(scaled);
        if (!(axes.eigenvalues()[0] > 0)) {
            std::printf("seed %llu: the covariance is not positive definite\n",
                        static_cast<unsigned long long>(one));
            continue;
        }
        for (int axis = 0; axis < 6; ++axis)
            ratios.push_back(std::abs(axes.eigenvectors().col(axis).dot(metres.cwiseProduct(error))) /
                             std::sqrt(axes.eigenvalues()[axis]));
    }
    const auto inside = std::count_if(distances.begin(), distances.end(),
                                      [](double distance) { return distance <= kChiSquare95; });
    double squares = 0;
    for (const double ratio : ratios) squares += ratio * ratio;
    std::printf(
        "coverage, %zu points: %td of %zu (%.1f %%); squared distance median %.1f, 95 %% %.1f, 99 %% %.1f; "
        "half axis / true spread: %.2f by the median error, %.2f by the RMS error\n",
        points, inside, distances.size(),
        100.0 * static_cast<double>(inside) / static_cast<double>(distances.size()), quantile(distances, 0.5),
        quantile(distances, 0.95), quantile(distances, 0.99), 0.6745 / quantile(ratios, 0.5),
        1 / std::sqrt(squares / static_cast<double>(ratios.size())));
}

void count(const char* title, const std::map<std::string, int>& verdicts, int total) {
    std::printf("%s: %d", title, total);
    for (const auto& [verdict, times] : verdicts) std::printf(", %s %d", verdict.c_str(), times);
    std::printf("\n");
}

/// Verdicts of results within 5 cm and 0.5 degrees at more than 40 % overlap.
void rightOnes(int wanted, std::uint64_t seed) {
    std::map<std::string, int> verdicts;
    int total = 0;
    for (std::uint64_t one = seed; total < wanted; ++one) {
        const TripodPair pair = simulateTripodPair(randomPair(one, 60000));
        const Pose truth = pair.targetFromSource();
        const auto result = registered(pair, wrongPose(truth, 0.5, 4, one), 4);
        if (!result || !right(result->targetFromSource.pose, truth) || result->overlap < 0.4) continue;
        ++total;
        ++verdicts[std::string(describe(result->verdict))];
        if (result->verdict != Verdict::accepted)
            std::printf("  right, seed %llu, %s: %s\n", static_cast<unsigned long long>(one),
                        std::string(describe(result->verdict)).c_str(), result->reasons.front().c_str());
    }
    count("right", verdicts, total);
}

/// A start that leads astray: moved along the road, turned by half or a quarter, or anywhere.
Pose astray(const TripodPair& pair, std::uint64_t how, std::uint64_t seed) {
    Random random(seed, 78);
    Pose move = Pose::Identity();
    if (how == 0)
        move.translation() << (random.uniform() < 0.5 ? -1 : 1) * random.uniform(4, 16),
            random.uniform(-1, 1), 0;
    else if (how == 1)
        move.linear() =
            Eigen::AngleAxisd(radians(random.uniform() < 0.7 ? 180 : 90), Eigen::Vector3d::UnitZ())
                .toRotationMatrix();
    else if (how == 2)
        return wrongPose(pair.targetFromSource(), random.uniform(2, 12), random.uniform(20, 120), seed);
    return pair.siteFromTarget.inverse() * move * pair.siteFromSource;
}

/// Verdicts of results over 10 cm or 1 degree off, and of pairs of two scenes.
void wrongOnes(int wanted, std::uint64_t seed) {
    std::map<std::string, int> verdicts;
    int total = 0;
    for (std::uint64_t one = seed; total < wanted; ++one) {
        TripodPairOptions options = randomPair(one, 60000);
        const std::uint64_t how = one % 4;
        if (how == 3) options.sourceScene = TripodSceneOptions{kindOf(Random(one, 79).below(10)), one + 5000};
        const TripodPair pair = simulateTripodPair(options);
        const auto result = registered(pair, astray(pair, how, one), 4);
        if (!result) continue;
        const Pose move = pair.targetFromSource() * result->targetFromSource.pose.inverse();
        const double off =
            (result->targetFromSource.pose.translation() - pair.targetFromSource().translation()).norm();
        if (how != 3 && off < 0.1 && rotationAngle(move.linear()) < radians(1)) continue;
        ++total;
        ++verdicts[std::string(describe(result->verdict))];
        if (result->verdict == Verdict::accepted)
            std::printf("  wrong, seed %llu, how %llu, kind %d, %.2f m off, ACCEPTED: %s\n",
                        static_cast<unsigned long long>(one), static_cast<unsigned long long>(how),
                        static_cast<int>(options.scene.kind), off, result->reasons.front().c_str());
    }
    count("wrong", verdicts, total);
}

}  // namespace
}  // namespace vestige

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "all";
    const int number = argc > 2 ? std::atoi(argv[2]) : 0;
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 900000;
    const std::size_t points = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 60000;
    if (what == "coverage" || what == "all") vestige::coverage(number ? number : 500, seed, points);
    if (what == "right" || what == "all") vestige::rightOnes(number ? number : 200, seed + 100000);
    if (what == "wrong" || what == "all") vestige::wrongOnes(number ? number : 200, seed + 200000);
    return 0;
}
