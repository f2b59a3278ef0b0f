// two_sum() of core/numerics/exact.h in the lanes of any vectors of doubles. Compiled for each
// instruction set.
#if defined(ETALON_TWO_SUM_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_TWO_SUM_LANES_INL_H
#undef ETALON_TWO_SUM_LANES_INL_H
#else
#define ETALON_TWO_SUM_LANES_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// See TwoTerm.
template <class Lanes>
struct TwoTermLanes {
    Lanes value, error;
};

template <class Lanes>
HWY_INLINE TwoTermLanes<Lanes> two_sum(Lanes a, Lanes b) {
    const Lanes s = a + b, bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
