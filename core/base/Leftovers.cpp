#include "core/base/Leftovers.h"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <fstream>

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// Process numbers mean something to one start of one machine, and in a container to that container alone.
const std::string& numberSpace() {
    // Never destroyed: a thread that still writes while the program ends may ask for it.
    static const std::string& space = *new std::string([] {
        std::string boot;
        std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
        struct stat processes {};
        if (::stat("/proc/self/ns/pid", &processes) == 0) boot += std::to_string(processes.st_ino);
        std::array<char, 256> host{};
        ::gethostname(host.data(), host.size() - 1);
        boot += host.data();
        std::uint32_t hash = 2166136261;  // FNV-1a
        for (const char c : boot) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619;
        std::array<char, 8> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
        return std::string(digits.data(), end);
    }());
    return space;
}

/// The process that the mark names, if it is one of this number space; else 0.
pid_t processHere(const std::string& mark) {
    pid_t process = 0;
    const auto number = std::from_chars(mark.data(), mark.data() + mark.size(), process);
    if (number.ec != std::errc() || process <= 0) return 0;
    return std::string(number.ptr, mark.data() + mark.size()) == "-" + numberSpace() ? process : 0;
}

bool isOld(const fs::path& place) {
    std::error_code unknown;
    const auto written = fs::last_write_time(place, unknown);
    return !unknown && fs::file_time_type::clock::now() - written > std::chrono::hours(24);
}

}  // namespace

std::string ownerMark() {
    return std::to_string(::getpid()) + "-" + numberSpace();
}

bool ownerIsGone(const std::string& mark) {
    const pid_t process = processHere(mark);
    return process != 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

std::vector<fs::path> leftovers(const fs::path& folder, const std::string& prefix,
                                const std::string& suffix) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) ||
            !name.ends_with(suffix))
            continue;
        const std::string mark = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
        if (mark.find_first_not_of("0123456789abcdef-") != std::string::npos) continue;
        // Age says nothing of a process that is known to live: it may write for days, and a second name of an
        // old file is as old as that file.
        const bool abandoned = processHere(mark) != 0 ? ownerIsGone(mark) : isOld(entry->path());
        if (abandoned) found.push_back(entry->path());
    }
    return found;
}

}  // namespace vestige
