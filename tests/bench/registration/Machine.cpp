#include "tests/bench/registration/Machine.h"

#include <stdlib.h>

#include <Eigen/Core>
#include <fstream>
#include <sstream>
#include <thread>

namespace vestige::bench {
namespace {

std::string processor() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

}  // namespace

double loadAverage() {
    double load = 0;
    return getloadavg(&load, 1) == 1 ? load : 0;
}

std::string describeMachine() {
    std::ostringstream text;
    const char* commit = getenv("VESTIGE_BENCH_COMMIT");
    text << "- " << processor() << ", " << std::thread::hardware_concurrency()
         << " cores; load average at the start " << loadAverage() << "\n"
         << "- Vestige " << (commit ? commit : "(commit not told)") << "; GCC " << __VERSION__
         << "; ours: `" VESTIGE_BENCH_OUR_FLAGS "`\n"
         << "- PCL " VESTIGE_BENCH_PCL_VERSION
            ": compiled with the distribution's binaries for any x86-64 "
            "(`-O3`), and all its templates with `" VESTIGE_BENCH_AVX2_FLAGS "`; Eigen "
         << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION << "\n"
#ifdef VESTIGE_BENCH_OPEN3D
         << "- Open3D " VESTIGE_BENCH_OPEN3D ", the distribution's binary\n";
#else
         << "- Open3D: skipped, not installed\n";
#endif
    return text.str();
}

}  // namespace vestige::bench
