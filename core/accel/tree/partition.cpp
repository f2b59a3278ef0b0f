#include "core/accel/tree/partition.h"

#include <algorithm>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/accel/tree/partition.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE void store(const Bounds& b, BoundedPrimitive& p) {
    std::memcpy(static_cast<void*>(&p), &b, sizeof(b));
}

SplitSets partition(std::span<BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, const SplitSides& sides) {
    const auto plane = static_cast<float>(split.bin);
    SideCentres centres;
    // What goes left is before `middle`; what goes right is between `middle` and i.
    std::size_t middle = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Bounds b = Bounds::of(primitives[i]);
        const bool is_left = binning.is_below(b, split.axis, plane);
        store(Bounds::of(primitives[middle]), primitives[i]);
        store(b, primitives[middle]);
        middle += is_left;
        centres.extend(twice_centre(b), is_left);
    }
    return {{primitives.first(middle), sides.left.bounds, centres.left},
            {primitives.subspan(middle), sides.right.bounds, centres.right}};
}

SideCentres scatter(std::span<const BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, BoundedPrimitive* left, BoundedPrimitive* right) {
    const auto plane = static_cast<float>(split.bin);
    SideCentres centres;
    for (const BoundedPrimitive& p : primitives) {
        const Bounds b = Bounds::of(p);
        const bool is_left = binning.is_below(b, split.axis, plane);
        store(b, *(is_left ? left : right));
        left += is_left;
        right += !is_left;
        centres.extend(twice_centre(b), is_left);
    }
    return centres;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(partition);
HWY_EXPORT(scatter);

SplitSets partition(std::span<BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, const SplitSides& sides) {
    return HWY_DYNAMIC_DISPATCH(partition)(primitives, binning, split, sides);
}

SideCentres scatter(std::span<const BoundedPrimitive> primitives, const Binning& binning,
                    const Split& split, BoundedPrimitive* left, BoundedPrimitive* right) {
    return HWY_DYNAMIC_DISPATCH(scatter)(primitives, binning, split, left, right);
}

std::size_t smaller_half(std::span<BoundedPrimitive> primitives) {
    const std::size_t middle = primitives.size() / 2;
    const auto size = [](const BoundedPrimitive& p) { return Bounds::of(p).half_area(); };
    std::nth_element(primitives.begin(), primitives.begin() + middle, primitives.end(),
                     [&](const auto& a, const auto& b) { return size(a) < size(b); });
    return middle;
}

}  // namespace etalon
#endif
