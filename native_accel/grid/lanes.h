// Operations on four floats at once for the traversal of a grid.
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "core/numerics/vec.h"
#include "native_accel/grid/float4.h"

namespace etalon {

HWY_INLINE Float4 select(Mask4 mask, Float4 yes, Float4 no) {
    return mask ? yes : no;
}

/// Returns the lanes where the mask holds, and zero in the others.
HWY_INLINE Float4 keep(Mask4 mask, Float4 value) {
    return reinterpret_cast<Float4>(mask & reinterpret_cast<Mask4>(value));
}

/// Returns the smallest lane, in every lane.
HWY_INLINE Float4 min_of_lanes(Float4 v) {
    v = min(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
    return min(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
}

/// Returns one bit for each lane.
HWY_INLINE unsigned bits(Mask4 mask) {
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    const Mask4 bit = mask & Mask4{1, 2, 4, 8};
    return static_cast<unsigned>(bit[0] | bit[1] | bit[2] | bit[3]);
#endif
}

HWY_INLINE Mask4 truncated(Float4 v) {
    return __builtin_convertvector(v, Mask4);
}
HWY_INLINE Float4 to_float(Mask4 v) {
    return __builtin_convertvector(v, Float4);
}

/// Returns three components and a fourth lane for the traversal.
HWY_INLINE Float4 lanes(const Vec3f& v, float fourth) {
    return Float4{v.x, v.y, v.z, fourth};
}

}  // namespace etalon
