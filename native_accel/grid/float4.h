#pragma once

#include <hwy/base.h>

#include <cstdint>

namespace etalon {

/// Four floats as a vector of GCC and Clang, for which every x86-64 and arm64 has instructions.
/// Operations on it are always inlined, so that they are compiled for the instruction set of the
/// caller.
using Float4 = float __attribute__((vector_size(16)));

/// Result of comparing two Float4: all bits of a lane are set if it holds, else none.
using Mask4 = std::int32_t __attribute__((vector_size(16)));

HWY_INLINE Float4 broadcast(float x) {
    return Float4{x, x, x, x};
}
HWY_INLINE Float4 max(Float4 a, Float4 b) {
    return a > b ? a : b;
}
HWY_INLINE Float4 min(Float4 a, Float4 b) {
    return a < b ? a : b;
}
HWY_INLINE Float4 abs(Float4 a) {
    return max(a, -a);
}

}  // namespace etalon
