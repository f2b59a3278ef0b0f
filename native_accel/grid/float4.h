#pragma once

#include <cstdint>

namespace etalon {

/// Four floats side by side. GCC's and Clang's vectors: every x86-64 and arm64 has instructions for
/// them, so there is nothing to choose at run time.
using Float4 = float __attribute__((vector_size(16)));

/// What comparing two Float4 gives: all bits of a lane where it holds, else none.
using Mask4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 broadcast(float x) {
    return Float4{x, x, x, x};
}
inline Float4 max(Float4 a, Float4 b) {
    return a > b ? a : b;
}
inline Float4 min(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline Float4 abs(Float4 a) {
    return max(a, -a);
}

inline bool any(Mask4 mask) {
    using Halves = std::int64_t __attribute__((vector_size(16)));
    const auto halves = reinterpret_cast<Halves>(mask);
    return (halves[0] | halves[1]) != 0;
}

}  // namespace etalon
