#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/UnitWords.h"
#include "core/base/Units.h"
#include "core/registration/InitialPose.h"
#include "core/registration/ndt/CellMoments.h"

namespace vestige {
namespace {

/// Sum of the distances between consecutive points of one side, round to the first.
double length(std::span<const PointPair> pairs, Eigen::Vector3d PointPair::*side) {
    double sum = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        sum += (pairs[i].*side - pairs[(i + 1) % pairs.size()].*side).norm();
    return sum;
}

UnitGuess guessFromPairs(std::span<const PointPair> pairs) {
    const double source = length(pairs, &PointPair::source);
    const double ratio = source > 0 ? length(pairs, &PointPair::target) / source : 1;
    UnitGuess guess;
    LengthUnit unit = ratio < std::sqrt(0.001) ? LengthUnit::millimetre : LengthUnit::metre;
    // Units that are rarer must be met more closely; the two feet look the same here.
    for (const LengthUnit rare : {LengthUnit::foot, LengthUnit::inch, LengthUnit::centimetre})
        if (ratio > 0.9 * metresPer(rare) && ratio < metresPer(rare) / 0.9) unit = rare;
    const double expected = guess.metresPerUnit = metresPer(unit);
    guess.certain = ratio > 0.8 * expected && ratio < 1.25 * expected;
    guess.reason = "The picked points are " + fixedText(ratio, ratio < 0.1 ? 6 : 3) +
                   " times as far apart in the target as in the source, so the source is in " +
                   std::string(nameOf(unit)) +
                   (guess.certain ? "" : "; the ratio fits no unit well, check the pairs");
    return guess;
}

/// Spread over the cloud's order; far more than there are cells of a surface.
constexpr std::size_t kSamples = 1'000'000;

struct Size {
    double extent = 0;   // diagonal of the bounds
    double spacing = 0;  // of points on the surface

    Size operator*(double scale) const { return {scale * extent, scale * spacing}; }
};

Size sizeOf(const TriangleMesh& geometry) {
    const PointCloud& cloud = geometry.vertices;
    Size size{cloud.bounds().diagonal(), 0};
    if (!(size.extent > 0)) return size;
    std::vector<Eigen::Vector3f> offsets(std::min(cloud.size(), kSamples));
    const Eigen::Vector3d centre = cloud.bounds().centre();
    for (std::size_t i = 0; i < offsets.size(); ++i)
        offsets[i] = (cloud.point(i * cloud.size() / offsets.size()) - centre).cast<float>();
    const double cell = size.extent / 64;
    const double area = cell * cell * static_cast<double>(gatherPoints(offsets, VoxelGrid(cell)).size());
    size.spacing = std::sqrt(area / static_cast<double>(cloud.size()));
    return size;
}

}  // namespace

UnitGuess guessUnit(const TriangleMesh& target, double metresPerTarget, const TriangleMesh& source,
                    std::span<const PointPair> pairs, std::optional<double> ofFile) {
    if (ofFile) ofFile = exactUnit(*ofFile);
    if (pairs.size() >= 2) {
        UnitGuess guess = guessFromPairs(pairs);
        if (!ofFile) return guess;
        const double apart = *ofFile / guess.metresPerUnit;
        if (guess.certain && (apart < 0.8 || apart > 1.25)) {
            guess.reason = guess.reason + ", although its file says " + unitWords(*ofFile);
            return guess;
        }
    }
    if (ofFile) return {*ofFile, true, "The file of the source says that it is in " + unitWords(*ofFile)};
    // A scan that is registered to a scene shows a part of it: as metres it must not be far larger than the
    // scene, nor both as large and ten times coarser.
    const Size scene = sizeOf(target) * metresPerTarget;
    const Size scan = sizeOf(source);
    UnitGuess guess;
    const bool tooLarge = scan.extent > 5 * scene.extent;
    const bool tooCoarse = scan.extent > 0.5 * scene.extent && scan.spacing > 10 * scene.spacing;
    if (scene.extent > 0 && (tooLarge || tooCoarse)) {
        guess.metresPerUnit = metresPer(LengthUnit::millimetre);
        guess.certain = scan.extent > 50 * scene.extent;
    } else {
        guess.certain = scan.extent < 3 * scene.extent && scan.spacing < 10 * scene.spacing;
    }
    guess.reason = "The source is " + fixedText(scan.extent, 2) + " units across with a point every " +
                   fixedText(scan.spacing, 3) + ", the target " + fixedText(scene.extent, 2) +
                   " m with a point every " + fixedText(scene.spacing, 3) +
                   " m, so the source is taken to be in " + unitWords(guess.metresPerUnit);
    return guess;
}

}  // namespace vestige
