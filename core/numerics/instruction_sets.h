// Instruction sets that code is compiled for; one is chosen when the program starts. Must be
// included before any header of Highway.
#pragma once

// SSSE3 and AVX-512 gain nothing over their neighbours for eight floats. (0x50 are its variants for
// Zen 4 and Sapphire Rapids, for which older releases have no names.) Vectors without a fixed size
// cannot be members. A file that computes much in doubles, of which AVX-512 has eight to a vector,
// or multiplies words, enables it by ETALON_WITH_AVX3.
#define ETALON_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_AVX3_DL | 0x50 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#ifdef ETALON_WITH_AVX3
#define HWY_DISABLED_TARGETS ETALON_DISABLED_TARGETS
#else
#define HWY_DISABLED_TARGETS (ETALON_DISABLED_TARGETS | HWY_AVX3)
#endif
