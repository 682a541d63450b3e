#include "core/base/Parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/CancelScope.h"
#include "core/base/Result.h"

namespace vestige {
namespace {

struct Threads {
    std::mutex mutex;
    int count = 0;
    std::unique_ptr<tbb::global_control> limit;
    std::shared_ptr<tbb::task_arena> arena;
};

Threads& threads() {
    static Threads instance;
    return instance;
}

std::shared_ptr<tbb::task_arena> currentArena() {
    Threads& state = threads();
    const std::scoped_lock lock(state.mutex);
    return state.arena;
}

}  // namespace

void setThreadCount(int count) {
    Threads& state = threads();
    const std::scoped_lock lock(state.mutex);
    state.count = std::max(0, count);
    state.arena.reset();
    state.limit.reset();
    if (state.count == 0) return;
    state.limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                        static_cast<std::size_t>(state.count));
    state.arena = std::make_shared<tbb::task_arena>(state.count);
}

int threadCount() {
    Threads& state = threads();
    const std::scoped_lock lock(state.mutex);
    return state.count > 0 ? state.count : tbb::info::default_concurrency();
}

void parallelChunks(std::size_t count, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
    grain = std::max<std::size_t>(1, grain);
    const std::size_t chunks = (count + grain - 1) / grain;
    const JobControl* job = CancelScope::current();
    const auto runChunk = [&](std::size_t chunk) {
        if (job && job->cancelled()) throw ErrorException(cancelledError());
        // Loops within this one, on other threads, belong to the same job.
        std::optional<CancelScope> scope;
        if (job && !CancelScope::current()) scope.emplace(*job);
        body(chunk, chunk * grain, std::min(count, (chunk + 1) * grain));
    };
    if (chunks <= 1 || threadCount() == 1) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) runChunk(chunk);
        return;
    }
    const auto loop = [&] { tbb::parallel_for<std::size_t>(0, chunks, runChunk); };
    if (const auto arena = currentArena()) {
        arena->execute(loop);
    } else {
        loop();
    }
}

void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& body) {
    parallelChunks(count, grain, [&](std::size_t, std::size_t begin, std::size_t end) { body(begin, end); });
}

}  // namespace vestige
