#include <algorithm>
#include <map>
#include <numbers>
#include <stdexcept>

#include "core/base/Random.h"
#include "core/simulation/SceneBuilder.h"
#include "core/simulation/Survey.h"
#include "tests/bench/auto/Trial.h"

namespace vestige::bench {
namespace {

constexpr std::uint64_t kTrialsPerScene = 5;  // a scene takes seconds to scan

struct CarSize {
    double length_m = 0;
    double width_m = 0;
    double height_m = 0;
};

struct CarScene {
    int cars = 5;
    bool equal = false;   ///< all of one size
    bool absent = false;  ///< the car that was scanned has driven away before the flight
    bool side = false;    ///< the scan goes on along the left side
    double seconds = 8;   ///< of flight
    double circle_s = 8;  ///< for a whole circle
    double metresPerUnit = 0.001;
};

CarSize sizeOfCar(Random& random) {
    return {random.uniform(3.7, 5.0), random.uniform(1.65, 1.95), random.uniform(1.4, 1.75)};
}

/// The front of a car swept as an operator does: across, round both corners, over the bonnet to the
/// windscreen, and perhaps along the left side. Metres in the car's frame.
HandheldSpec frontSweeps(const CarSize& car, bool side) {
    const double nose = 0.5 * car.length_m;
    HandheldSpec layer{"front", "car 0", 0.003, {}};
    layer.sweeps = {{{nose + 0.49, -0.75, 0.8},
                     {nose + 0.49, 0.75, 0.8},
                     {nose, -0.7, 0.52},
                     {nose, 0.7, 0.52},
                     0.42,
                     0.6,
                     6},
                    {{nose + 0.1, -1.1, 0.8},
                     {nose + 0.1, -1.1, 0.8},
                     {nose - 0.26, -0.73, 0.55},
                     {nose - 0.26, -0.73, 0.55},
                     0.45,
                     0.6,
                     1},
                    {{nose + 0.1, 1.1, 0.8},
                     {nose + 0.1, 1.1, 0.8},
                     {nose - 0.26, 0.73, 0.55},
                     {nose - 0.26, 0.73, 0.55},
                     0.45,
                     0.6,
                     1}};
    for (const auto& [back, up] : {std::pair{0.2, 1.3}, {0.7, 1.4}, {1.2, 1.55}})
        layer.sweeps.push_back({{nose - back, -0.75, up},
                                {nose - back, 0.75, up},
                                {nose - back - 0.2, -0.68, up - 0.47},
                                {nose - back - 0.2, 0.68, up - 0.47},
                                0.4,
                                0.45,
                                5});
    if (side)
        layer.sweeps.push_back({{nose - 0.35, 1.45, 0.9},
                                {nose - 2.2, 1.45, 0.9},
                                {nose - 0.4, 0.92, 0.7},
                                {nose - 2.25, 0.92, 0.7},
                                0.46,
                                0.46,
                                5});
    return layer;
}

SceneSpec specOf(const CarScene& scene, std::uint64_t number, bool withScanned) {
    Random random(800000 + number, 81);
    SceneBuilder builder("cars");
    builder.strip("road", {0, 0, 0}, 70, 16, "asphalt");
    for (const double side : {-1.0, 1.0}) {
        const std::string name = side > 0 ? " north" : " south";
        builder.strip("verge" + name, {0, 20 * side, 0.1}, 70, 24, "grass", 0.03);
        builder.add("kerb" + name, "box", {0, 8.1 * side, 0}, 0,
                    {{"length_m", 70.0}, {"width_m", 0.2}, {"height_m", 0.12}, {"material", "concrete"}});
    }
    builder.add("house", "box", {-20, 16, 0}, random.uniform(0, 10),
                {{"length_m", 12.0}, {"width_m", 8.0}, {"height_m", 6.0}, {"material", "concrete"}});
    for (int i = 0; i < 2; ++i)
        builder.add("tree " + std::to_string(i), "tree",
                    {random.uniform(-12, 12), (i == 0 ? 1 : -1) * random.uniform(10, 12), 0.1}, 0,
                    {{"canopy_radius_m", 3.0}, {"clearance_m", 2.5}});
    builder.add("pole", "pole", {random.uniform(-10, 10), 9, 0.1}, 0,
                {{"height_m", 9.0}, {"diameter_m", 0.3}});
    builder.add("crate", "box", {random.uniform(-10, 10), -7, 0}, 30,
                {{"length_m", 0.75}, {"width_m", 0.55}, {"height_m", 0.42}, {"material", "equipment-case"}});
    std::vector<int> places{0, 1, 2, 3, 4, 5, 6, 7};  // a car's place in two lanes
    for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[random.below(i)]);
    CarSize scanned;
    CarSize size = sizeOfCar(random);
    for (int i = 0; i < scene.cars; ++i) {
        if (i > 0 && !scene.equal) size = sizeOfCar(random);
        if (i == 0) scanned = size;
        const double x = -13.5 + 9.0 * (places[static_cast<std::size_t>(i)] % 4) + random.uniform(-1.2, 1.2);
        const double y = (places[static_cast<std::size_t>(i)] < 4 ? -3.2 : 3.2) + random.uniform(-0.8, 0.8);
        const double heading = random.uniform(0, 360);
        if (i == 0 && !withScanned) continue;
        builder.add("car " + std::to_string(i), "car", {x, y, 0}, heading,
                    {{"length_m", size.length_m},
                     {"width_m", size.width_m},
                     {"height_m", size.height_m},
                     {"paint", "white-paint"}});
    }
    builder.flight({{"radius_m", 12.0}, {"circle_s", scene.circle_s}});
    builder.photogrammetry({{"enabled", false}});
    if (withScanned) builder.handheld(frontSweeps(scanned, scene.side));
    return builder.take();
}

Survey surveyOf(const CarScene& scene, std::uint64_t number, bool withScanned, double seconds) {
    auto survey = surveyScene(specOf(scene, number, withScanned), 800000 + number, seconds, {});
    if (!survey) throw std::runtime_error(survey.error().sentence());
    return std::move(*survey);
}

/// A million of the points that lie in the square of 60 m round the site's middle, less where there are less.
PointCloud siteOf(const Survey& survey) {
    const PointCloud& cloud = survey.aerial.cloud;
    std::vector<std::uint32_t> inside;
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
        if ((cloud.point(i) - survey.worldFromSite).head<2>().cwiseAbs().maxCoeff() < 30) inside.push_back(i);
    const std::size_t count = std::min<std::size_t>(1000000, inside.size());
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k < count; ++k) kept.push_back(inside[k * inside.size() / count]);
    return cloud.select(kept);
}

struct ScannedLot {
    std::shared_ptr<const TriangleMesh> target;
    PointCloud front;
    Similarity truth;
    std::vector<Similarity> twins;
};

std::shared_ptr<const ScannedLot> scannedLot(const CarScene& scene, std::uint64_t number) {
    auto lot = std::make_shared<ScannedLot>();
    Survey survey = surveyOf(scene, number, true, scene.seconds);
    const Similarity worldFromSite{Pose(Eigen::Translation3d(survey.worldFromSite)), 1};
    const HandheldScan& scan = survey.handheld.at(0).scan;
    lot->truth = worldFromSite * scan.siteFromLayer;
    lot->front = scan.cloud.transformed({Pose::Identity(), scan.siteFromLayer.scale});
    lot->truth.scale = 1;
    if (scene.equal) {
        const auto& poses = survey.scene.siteFromObject;
        const Pose carFromScan = poses.at("car 0").inverse() * scan.siteFromLayer.pose;
        for (int i = 1; i < scene.cars; ++i)
            lot->twins.push_back(worldFromSite *
                                 Similarity{poses.at("car " + std::to_string(i)) * carFromScan, 1});
    }
    if (scene.absent) survey = surveyOf(scene, number, false, scene.seconds);
    lot->target = std::make_shared<TriangleMesh>(TriangleMesh{siteOf(survey), {}});
    return lot;
}

std::map<std::string, CarScene> scenes() {
    std::map<std::string, CarScene> all{{"cars", {}}};
    all["cars-side"].side = true;
    all["cars-metres"].metresPerUnit = 1;
    all["cars-quarter-circle"].circle_s = 32;
    all["cars-equal"].equal = true;
    all["cars-absent"].absent = true;
    return all;
}

}  // namespace

std::optional<TrialSet> carSet(const std::string& name) {
    const auto known = scenes();
    const auto found = known.find(name);
    if (found == known.end()) return std::nullopt;
    const CarScene scene = found->second;
    TrialSet set{name, 0.1, 2, {}};
    set.trial = [scene, lot = std::shared_ptr<const ScannedLot>(),
                 last = ~std::uint64_t{0}](std::uint64_t number) mutable {
        if (number / kTrialsPerScene != last) lot = scannedLot(scene, last = number / kTrialsPerScene);
        Trial trial{lot->target, {lot->front, {}}, lot->truth, {}, !scene.absent, lot->twins};
        moveAway(trial, number, scene.metresPerUnit);
        return trial;
    };
    return set;
}

std::vector<std::string> carSets() {
    std::vector<std::string> names;
    for (const auto& [name, scene] : scenes()) names.push_back(name);
    return names;
}

}  // namespace vestige::bench
