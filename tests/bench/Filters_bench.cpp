// The filters beside PCL's, on one cloud in one run: a street of 20 m seen by a turning scanner, 2 million
// points (the mean filter and outliers: 300 000).
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/filters/Neighbourhood.h"
#include "core/filters/Outliers.h"
#include "core/filters/VoxelDownsample.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/bench/PclFilters.h"

namespace {

using namespace vestige;

PointCloud street(std::size_t count) {
    Random random(2);
    PointCloudBuilder builder(Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < count; ++i) {
        const double bearing = 2 * std::numbers::pi * static_cast<double>(i % 9973) / 9973;
        const double range = 10 * std::sqrt(random.uniform());
        const double height = i % 5 == 0 ? random.uniform(0, 4) : 0.02 * random.normal();
        builder.add({range * std::cos(bearing), range * std::sin(bearing), height});
    }
    return std::move(builder).build();
}

const PointCloud& large() {
    static const PointCloud cloud = street(2000000);
    return cloud;
}
const PointCloud& small() {
    static const PointCloud cloud = street(300000);
    return cloud;
}

void voxelsOurs(benchmark::State& state) {
    setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state) state.counters["points"] = static_cast<double>(downsample(large(), 0.1)->size());
}
void voxelsPcl(benchmark::State& state) {
    const PclFilters pcl(large());
    for (auto _ : state) state.counters["points"] = static_cast<double>(pcl.voxelGrid(0.1F));
}
void meanOurs(benchmark::State& state) {
    setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(filterNeighbourhood(small(), {NeighbourhoodFilter::mean, 0.1})->size());
}
void gaussianOurs(benchmark::State& state) {
    setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(filterNeighbourhood(small(), {NeighbourhoodFilter::gaussian, 0.1})->size());
}
void medianOurs(benchmark::State& state) {
    setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(filterNeighbourhood(small(), {NeighbourhoodFilter::median, 0.1})->size());
}
void meanPcl(benchmark::State& state) {
    const PclFilters pcl(small());
    for (auto _ : state) benchmark::DoNotOptimize(pcl.meanFilter(0.1F));
}
void statisticalOurs(benchmark::State& state) {
    setThreadCount(static_cast<int>(state.range(0)));
    OutlierOptions options;
    options.method = OutlierMethod::statistical;
    for (auto _ : state)
        state.counters["points"] = static_cast<double>(removeOutliers(small(), options)->size());
}
void statisticalPcl(benchmark::State& state) {
    const PclFilters pcl(small());
    for (auto _ : state) state.counters["points"] = static_cast<double>(pcl.statistical(8, 3));
}

BENCHMARK(voxelsOurs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(voxelsPcl)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(meanOurs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(meanPcl)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(gaussianOurs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(medianOurs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(statisticalOurs)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(statisticalPcl)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
