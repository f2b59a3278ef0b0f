#include "core/sampling/seeded_points.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/seeded_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/hash-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Makes the points, padding included, by the steps of ScrambledSobol.
void make_points(const PointNames& names, Vec2* points) {
    const Words::Tag tag;
    for (std::size_t i = 0; i < names.size(); i += hn::Lanes(tag)) {
        const Words seed(hn::LoadU(tag, names.seeds() + i));
        const Words index(hn::LoadU(tag, names.indices() + i));
        store_unit_interval(
            scrambled_point(index, hashed(seed, 0), hashed(seed, 1), hashed(seed, 2)), points + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_points);

std::span<const Vec2> SeededPoints::make(Sampler sampler) {
    if (points_.size() < names_.padded_size()) points_.resize(2 * names_.padded_size());
    if (sampler == Sampler::sobol) {
        HWY_DYNAMIC_DISPATCH(make_points)(names_, points_.data());
    } else {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            points_[i] = uniform_random(names_.indices()[i], names_.seeds()[i]);
        }
    }
    return std::span<const Vec2>(points_).first(names_.size());
}

}  // namespace etalon
#endif
