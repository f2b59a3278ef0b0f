#include "core/accel/tree/binning.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/accel/tree/binning.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void count(const Binning& binning, std::span<const BoundedPrimitive> primitives,
           const LeafWeights& weights, BinsByAxis& bins) {
    using Numbers = std::int32_t __attribute__((vector_size(16)));
    for (const BoundedPrimitive& p : primitives) {
        const Bounds b = Bounds::of(p);
        const std::uint32_t weight = weights.weight(p.kind);
        const auto bin = __builtin_convertvector(binning.positions(b), Numbers);
        for (int k = 0; k < 3; ++k) bins[k][bin[k]].add(b, weight);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(count);

Binning::Binning(const Bounds& centres, int bins)
    : origin_(centres.min), scale_(Bounds::corner(0)), bins_(bins) {
    // Far enough below the number of bins that no rounding puts the largest centre into bin `bins`.
    const float highest = static_cast<float>(bins) * (1 - 0x1p-20F);
    for (int k = 0; k < 3; ++k) {
        const float scale = highest / (centres.max[k] - centres.min[k]);
        // Zero for one bin: where the extent is zero or too small to divide by.
        if (std::isfinite(scale)) scale_[k] = scale;
    }
}

void Bins::count(const Binning& binning, std::span<const BoundedPrimitive> primitives,
                 const LeafWeights& weights) {
    size_ = binning.bins();
    for (auto& axis : bins_) std::fill_n(axis.begin(), size_, Bin());
    HWY_DYNAMIC_DISPATCH(count)(binning, primitives, weights, bins_);
}

void Bins::add(const Bins& other) {
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < size_; ++i) bins_[k][i].add(other.at(k, i));
    }
}

Bin Bins::sum(int axis, int begin, int end) const {
    Bin result;
    for (int i = begin; i < end; ++i) result.add(at(axis, i));
    return result;
}

}  // namespace etalon
#endif
