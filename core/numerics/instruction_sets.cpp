// Stands for Highway's library, of which the headers need three functions: what this processor has,
// what was chosen and, in builds with sanitizers, what ends the program if an assertion fails. The
// library itself measures the resolution of a clock whenever a program that links it starts, which
// takes 5 ms, half of the time that a start takes.
#include "core/numerics/instruction_sets.h"

#include <hwy/base.h>
#include <hwy/targets.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace {

#if HWY_ARCH_X86

/// Returns whether the instructions lzcnt and those of f16c exist. Not every compiler knows these
/// names.
bool has_lzcnt_and_f16c() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    const bool f16c = __get_cpuid(1, &a, &b, &c, &d) != 0 && (c >> 29 & 1) != 0;
    const bool lzcnt = __get_cpuid(0x80000001, &a, &b, &c, &d) != 0 && (c >> 5 & 1) != 0;
    return f16c && lzcnt;
}

// What each target needs is what hwy/ops/set_macros-inl.h lets the compiler use for it.

bool has_sse4() {
    return __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.1") &&
           __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
           __builtin_cpu_supports("aes");
}

bool has_avx2() {
    return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && has_lzcnt_and_f16c();
}

bool has_avx3() {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512cd");
}

/// Returns the targets of Highway that the processor and the operating system support, of those
/// that instruction_sets.h enables.
std::int64_t find_supported() {
    __builtin_cpu_init();
    return HWY_STATIC_TARGET | HWY_SCALAR | (has_sse4() ? HWY_SSE4 : 0) |
           (has_avx2() ? HWY_AVX2 : 0) | (has_avx3() ? HWY_AVX3 : 0);
}

#else

/// Returns what the compiler may use everywhere.
std::int64_t find_supported() {
    return HWY_STATIC_TARGET | HWY_SCALAR;
}

#endif

/// Targets that a test sets in place of those found; 0 if none are set.
std::atomic<std::int64_t> set_by_test{0};

}  // namespace

namespace hwy {

std::int64_t SupportedTargets() {
    static const std::int64_t found = find_supported();
    const std::int64_t set = set_by_test.load(std::memory_order_relaxed);
    return set != 0 ? set : found;
}

void SetSupportedTargetsForTest(std::int64_t targets) {
    set_by_test.store(targets, std::memory_order_relaxed);
}

ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

/// Says nothing: the sanitizers, in whose builds alone it is called, report where a program aborts.
void Abort(const char*, int, const char*, ...) {
    std::abort();
}

}  // namespace hwy
