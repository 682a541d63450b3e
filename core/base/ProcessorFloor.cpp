// Compiled for every x86-64 machine, unlike the rest (docs/decisions/0006-instruction-set-floor.md): it must
// run where the rest cannot.
#include <unistd.h>

#include <cstring>

namespace {

bool hasFloor() {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}

/// Before any static object of the program is made: those are compiled for the floor already.
__attribute__((constructor(101))) void refuseOlderProcessors() {
    if (hasFloor()) return;
    constexpr const char* kSentence =
        "vestige: this processor lacks AVX2 and FMA (x86-64-v3, built since 2013), which every result is "
        "computed with; run it on a newer machine\n";
    constexpr int kNoTrustworthyResult = 4;
    constexpr int kNoOutput = 5;
    _exit(write(STDERR_FILENO, kSentence, std::strlen(kSentence)) < 0 ? kNoOutput : kNoTrustworthyResult);
}

}  // namespace
