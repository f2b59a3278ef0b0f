// The choice of an instruction set is the one that Highway's own library makes.
#include "core/numerics/instruction_sets.h"

#include <dlfcn.h>
#include <hwy/targets.h>

#include "tests/catch.h"

TEST_CASE("the instruction sets found are those that Highway finds", "[numerics]") {
    void* const library = ::dlopen("libhwy.so.1", RTLD_NOW | RTLD_LOCAL);
    REQUIRE(library != nullptr);
    void* const symbol = ::dlsym(library, "_ZN3hwy16SupportedTargetsEv");
    REQUIRE(symbol != nullptr);
    const std::int64_t theirs = reinterpret_cast<std::int64_t (*)()>(symbol)();
#if HWY_ARCH_X86
    const std::int64_t chosen_from = HWY_SSE4 | HWY_AVX2 | HWY_AVX3;
#else
    const std::int64_t chosen_from = HWY_STATIC_TARGET;
#endif
    CHECK((hwy::SupportedTargets() & chosen_from) == (theirs & chosen_from));
    CHECK((hwy::SupportedTargets() & HWY_STATIC_TARGET) != 0);
}

TEST_CASE("a test can set an instruction set", "[numerics]") {
    const std::int64_t found = hwy::SupportedTargets();
    hwy::SetSupportedTargetsForTest(HWY_STATIC_TARGET);
    CHECK(hwy::SupportedTargets() == HWY_STATIC_TARGET);
    hwy::SetSupportedTargetsForTest(0);
    CHECK(hwy::SupportedTargets() == found);
}
