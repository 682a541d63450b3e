#include "core/io/MappingFaults.h"

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <mutex>
#include <utility>

namespace vestige {
namespace {

/// Read by the signal handler: atomics only, and never moved. A place belongs to the one who set `taken`;
/// `end` is set last and cleared first, so that a range is seen whole or not at all.
struct Place {
    std::atomic<bool> taken{false};
    std::atomic<std::uintptr_t> begin{0};
    std::atomic<std::uintptr_t> end{0};
    std::atomic<bool> faulted{false};
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

std::array<Place, 1024> places;
std::uintptr_t pageSize = 4096;
struct sigaction before {};

/// mmap and sigaction are system calls that take no lock and no memory of the program.
void onBusError(int number, siginfo_t* facts, void* context) {
    const int kept = errno;
    const auto address = reinterpret_cast<std::uintptr_t>(facts->si_addr);
    for (Place& place : places) {
        const std::uintptr_t end = place.end.load(std::memory_order_acquire);
        if (address >= end || address < place.begin.load(std::memory_order_relaxed)) continue;
        const std::uintptr_t page = address & ~(pageSize - 1);
        place.faulted.store(true);
        void* zeros = ::mmap(reinterpret_cast<void*>(page), end - page, PROT_READ,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
        errno = kept;
        if (zeros != MAP_FAILED) return;
        break;
    }
    if ((before.sa_flags & SA_SIGINFO) != 0 && before.sa_sigaction)
        return before.sa_sigaction(number, facts, context);
    // Not ours: on return the access is tried again and meets what was set before.
    ::sigaction(SIGBUS, &before, nullptr);
}

void install() {
    static std::once_flag once;
    std::call_once(once, [] {
        pageSize = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
        struct sigaction action {};
        action.sa_sigaction = onBusError;
        action.sa_flags = SA_SIGINFO | SA_NODEFER | SA_ONSTACK;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(SIGBUS, &action, &before);
    });
}

}  // namespace

MappingWatch::MappingWatch(const void* begin, std::size_t size) {
    install();
    const std::uintptr_t from = reinterpret_cast<std::uintptr_t>(begin);
    for (std::size_t i = 0; i < places.size(); ++i) {
        bool free = false;
        if (!places[i].taken.compare_exchange_strong(free, true)) continue;
        places[i].faulted.store(false);
        places[i].begin.store(from);
        places[i].end.store((from + size + pageSize - 1) & ~(pageSize - 1), std::memory_order_release);
        place_ = static_cast<int>(i);
        return;
    }
}

MappingWatch::~MappingWatch() {
    if (place_ < 0) return;
    Place& place = places[static_cast<std::size_t>(place_)];
    place.end.store(0);
    place.begin.store(0);
    place.taken.store(false);
}

MappingWatch::MappingWatch(MappingWatch&& other) noexcept : place_(std::exchange(other.place_, -1)) {}

bool MappingWatch::faulted() const {
    return place_ >= 0 && places[static_cast<std::size_t>(place_)].faulted.load();
}

}  // namespace vestige
