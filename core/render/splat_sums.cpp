#include "core/render/splat_sums.h"

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/splat_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/two_sum_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The channels of a pixel in lanes; in turns where vectors are shorter.
using ChannelsTag = hn::CappedTag<double, WeightedSample::channels>;
using Channels = hn::Vec<ChannelsTag>;

/// The values of a sample with the weights of its columns.
class WeightedRow {
  public:
    HWY_INLINE explicit WeightedRow(const WeightedSample& sample)
        : size_(WeightedSample::channels * sample.columns) {
        double* to = values_;
        for (std::size_t u = 0; u < sample.columns; ++u, to += WeightedSample::channels) {
            const Channels weight = hn::Set(ChannelsTag(), sample.across[u]);
            for (std::size_t k = 0; k < WeightedSample::channels; k += hn::Lanes(ChannelsTag())) {
                hn::Store(weight * hn::LoadU(ChannelsTag(), sample.values + k), ChannelsTag(),
                          to + k);
            }
        }
    }

    HWY_INLINE void add(double weight, double* sums) const {
        for (std::size_t i = 0; i < size_; i += hn::Lanes(ChannelsTag())) {
            const Channels sum = hn::LoadU(ChannelsTag(), sums + i);
            hn::StoreU(sum + term(i, weight), ChannelsTag(), sums + i);
        }
    }

    HWY_INLINE void add(double weight, double* sums, double* errors) const {
        for (std::size_t i = 0; i < size_; i += hn::Lanes(ChannelsTag())) {
            const auto sum = two_sum(hn::LoadU(ChannelsTag(), sums + i), term(i, weight));
            hn::StoreU(sum.value, ChannelsTag(), sums + i);
            const Channels error = hn::LoadU(ChannelsTag(), errors + i);
            hn::StoreU(error + sum.error, ChannelsTag(), errors + i);
        }
    }

  private:
    HWY_INLINE Channels term(std::size_t i, double weight) const {
        return hn::Set(ChannelsTag(), weight) * hn::Load(ChannelsTag(), values_ + i);
    }

    std::size_t size_;
    HWY_ALIGN double values_[WeightedSample::channels * WeightedSample::most_pixels];
};

void add_splats(const WeightedSample& sample, const SplatSums& to) {
    const WeightedRow row(sample);
    for (std::size_t v = 0; v < sample.rows; ++v) {
        double* const sums = to.sums + v * to.stride;
        if (to.errors == nullptr) {
            row.add(sample.down[v], sums);
        } else {
            row.add(sample.down[v], sums, to.errors + v * to.stride);
        }
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(add_splats);

void add_splats(const WeightedSample& sample, const SplatSums& to) {
    HWY_DYNAMIC_DISPATCH(add_splats)(sample, to);
}

}  // namespace etalon
#endif
