// The filters beside PCL's and nanoflann's in one interleaved run, from points in memory (each program's own)
// to the result:
//   bench_filters [room|tripod|...] [--benchmark_filter=...]
// The table of docs/benchmarks.md comes last.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>

#include "core/base/Parallel.h"
#include "core/filters/Neighbourhood.h"
#include "core/filters/Outliers.h"
#include "core/filters/VoxelDownsample.h"
#include "tests/bench/filters/FilterClouds.h"
#include "tests/bench/filters/NanoflannSearch.h"
#include "tests/bench/filters/PclFilters.h"
#include "tests/bench/filters/Scoreboard.h"

namespace {

using namespace vestige;

constexpr int kRounds = 5;
constexpr int kNeighbours = 20;
constexpr double kSigmas = 1;

/// A cloud as each program holds it; PCL's and nanoflann's are made when first needed, outside the time.
class Held {
  public:
    explicit Held(PointCloud cloud) : cloud_(std::move(cloud)) {}
    const PointCloud& ours() const { return cloud_; }
    const PclFilters& pcl() {
        if (!pcl_) pcl_ = std::make_unique<PclFilters>(cloud_);
        return *pcl_;
    }
    const NanoflannSearch& nanoflann() {
        if (!nanoflann_) nanoflann_ = std::make_unique<NanoflannSearch>(cloud_);
        return *nanoflann_;
    }

  private:
    PointCloud cloud_;
    std::unique_ptr<PclFilters> pcl_;
    std::unique_ptr<NanoflannSearch> nanoflann_;
};

using Work = std::function<std::size_t()>;

void add(const std::string& row, const std::string& peer, int threads, std::size_t points,
         const Work& prepare, const Work& work) {
    const std::string name = row + "/" + peer + "/" + std::to_string(threads);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) {
                                     prepare();
                                     setThreadCount(threads);
                                     std::size_t result = 0;
                                     for (auto _ : state) result = work();
                                     state.counters["points"] = static_cast<double>(points);
                                     state.counters["result"] = static_cast<double>(result);
                                 })
        ->Iterations(1)
        ->Repetitions(kRounds)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

void addVoxels(const std::string& cloud, const std::shared_ptr<Held>& held, double size) {
    const std::string row = "voxels " + std::to_string(size).substr(0, 4) + " m, " + cloud;
    const std::size_t points = held->ours().size();
    const Work pcl = [held] { return held->pcl(), std::size_t{0}; };
    const auto ours = [=](VoxelRepresentative representative) {
        return [=] { return downsample(held->ours(), size, representative)->size(); };
    };
    for (const int threads : {1, 2}) {
        add(
            row, "Vestige", threads, points, [] { return 0; }, ours(VoxelRepresentative::centroid));
        add(
            row, "Vestige, measured point", threads, points, [] { return 0; },
            ours(VoxelRepresentative::nearest));
    }
    const auto single = static_cast<float>(size);
    add(row, "PCL", 1, points, pcl, [=] { return held->pcl().voxelGrid(single, true); });
    add(row, "PCL, xyz only", 1, points, pcl, [=] { return held->pcl().voxelGrid(single, false); });
}

OutlierOptions outlierOptions() {
    OutlierOptions options;
    options.method = OutlierMethod::statistical;
    options.neighbours = kNeighbours;
    options.sigmas = kSigmas;
    return options;
}

void addOutliers(const std::string& cloud, const std::shared_ptr<Held>& held) {
    const std::string row = "outliers k = " + std::to_string(kNeighbours) + ", " + cloud;
    const std::size_t points = held->ours().size();
    for (const int threads : {1, 2}) {
        add(
            row, "Vestige", threads, points, [] { return 0; },
            [=] {
                OutlierOptions options;
                options.method = OutlierMethod::statistical;
                options.neighbours = kNeighbours;
                options.sigmas = kSigmas;
                return removeOutliers(held->ours(), options)->size();
            });
        add(
            row, "nanoflann search", threads, points, [=] { return held->nanoflann(), 0; },
            [=] { return static_cast<std::size_t>(held->nanoflann().nearestOfAll(kNeighbours + 1)); });
    }
    add(
        row, "nanoflann tree", 1, points, [] { return 0; },
        [=] { return NanoflannSearch(held->ours()), points; });
    add(
        row, "PCL", 1, points, [held] { return held->pcl(), 0; },
        [=] { return held->pcl().statistical(kNeighbours, kSigmas).size(); });
}

void addNeighbourhood(const std::string& cloud, const std::shared_ptr<Held>& held, double radius) {
    const std::string row = "mean within " + std::to_string(radius).substr(0, 4) + " m, " + cloud;
    const std::size_t points = held->ours().size();
    for (const int threads : {1, 2})
        for (const auto& [peer, filter] : {std::pair("Vestige", NeighbourhoodFilter::mean),
                                           std::pair("Vestige, Gaussian", NeighbourhoodFilter::gaussian),
                                           std::pair("Vestige, median", NeighbourhoodFilter::median)})
            add(
                row, peer, threads, points, [] { return 0; },
                [=, filter = filter] {
                    return filterNeighbourhood(held->ours(), {filter, radius})->size();
                });
    add(
        row, "PCL", 1, points, [held] { return held->pcl(), 0; },
        [=] { return static_cast<std::size_t>(held->pcl().meanFilter(static_cast<float>(radius))); });
}

/// How many points only one of the two programs keeps.
std::string agreement(const std::string& cloud, Held& held) {
    std::vector<float> numbers(held.ours().size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i);
    PointAttributes numbered;
    numbered.intensity = numbers;
    const auto ours = removeOutliers(held.ours().withAttributes(std::move(numbered)), outlierOptions());
    std::vector<std::int32_t> kept;
    for (const float number : ours->attributes().intensity) kept.push_back(static_cast<std::int32_t>(number));
    std::vector<std::int32_t> theirs = held.pcl().statistical(kNeighbours, kSigmas);
    std::sort(theirs.begin(), theirs.end());
    std::vector<std::int32_t> differing;
    std::set_symmetric_difference(kept.begin(), kept.end(), theirs.begin(), theirs.end(),
                                  std::back_inserter(differing));
    return "outliers, " + cloud + ": " + std::to_string(kept.size()) + " of " +
           std::to_string(numbers.size()) + " points kept, " + std::to_string(differing.size()) +
           " kept by only one of Vestige and PCL\n\n";
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<char*> arguments{argv[0]};
    std::vector<std::string> chosen;
    for (int i = 1; i < argc; ++i) {
        if (std::strncmp(argv[i], "--", 2) == 0) {
            arguments.push_back(argv[i]);
        } else {
            chosen.emplace_back(argv[i]);
        }
    }
    char interleaved[] = "--benchmark_enable_random_interleaving=true";
    arguments.push_back(interleaved);
    if (chosen.empty()) chosen = {"room", "tripod x10", "tripod", "street"};
    std::string agreements;
    for (const std::string& name : chosen) {
        auto cloud = filterCloud(name);
        if (!cloud) {
            std::cerr << name << ": skipped, no such cloud on this machine\n";
            continue;
        }
        const auto held = std::make_shared<Held>(std::move(*cloud));
        if (name == "room" || name == "tripod x10") {
            addVoxels(name, held, 0.1);
            addVoxels(name, held, 0.05);
        } else {
            addOutliers(name, held);
            agreements += agreement(name, *held);
        }
        if (name == "street") addNeighbourhood(name, held, 0.3);
    }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    Scoreboard board("PCL");
    benchmark::RunSpecifiedBenchmarks(&board);
    board.writeTable(std::cout);
    std::cout << '\n' << agreements;
    return 0;
}
