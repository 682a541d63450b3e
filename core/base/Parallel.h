#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace vestige {

/// Threads that parallel loops use from now on; 0 means all cores. Results never depend on it.
void setThreadCount(int count);
int threadCount();

/// Calls `body(chunk, begin, end)` for the consecutive chunks of [0, count); all but the last have `grain`
/// items, so the chunks, unlike the threads that run them, are the same on every machine. An exception thrown
/// by a body stops the loop and leaves it, as cancelling does within a CancelScope.
void parallelChunks(std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t chunk, std::size_t begin, std::size_t end)>& body);

/// parallelChunks for bodies that do not need the number of their chunk.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Sum of `part(begin, end)` over the chunks, added in the order of the chunks: bit-identical for any thread
/// count.
template <class Sum, class Part>
Sum parallelSum(std::size_t count, std::size_t grain, Sum zero, const Part& part) {
    std::vector<Sum> parts((count + grain - 1) / grain, zero);
    parallelChunks(count, grain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        parts[chunk] = part(begin, end);
    });
    Sum total = zero;
    for (const Sum& one : parts) total += one;
    return total;
}

}  // namespace vestige
