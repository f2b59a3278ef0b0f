#include "core/sampling/vertex_points.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/vertex_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/sobol-inl.h"

#ifndef ETALON_VERTEX_POINTS_ONCE
#define ETALON_VERTEX_POINTS_ONCE
namespace etalon {

/// Vertices in SoA layout: `count` of each, a multiple of SobolBatch::lanes.
struct VertexNames {
    const std::uint32_t *seed, *index;
    std::size_t count;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns a bijective mix of 32 bits (Wellons 2018, "Prospecting for Hash Functions": lowbias32).
HWY_INLINE Words mixed(Words x) {
    x = (x ^ right<16>(x)) * 0x7feb352dU;
    x = (x ^ right<15>(x)) * 0x846ca68bU;
    return x ^ right<16>(x);
}

/// Makes the points of set number `set` of all vertices. Each scramble of each set has a seed of
/// its own: a mix of the vertex's seed plus multiples of an odd number.
void make_set(const VertexNames& names, std::uint32_t set, Vec2* points) {
    const Words::Tag tag;
    const auto moved = [](Words seed, std::uint32_t times)
                           HWY_ATTR { return mixed(seed + times * 0x9e3779b9U); };
    for (std::size_t i = 0; i < names.count; i += hn::Lanes(tag)) {
        const Words seed(hn::LoadU(tag, names.seed + i)), index(hn::LoadU(tag, names.index + i));
        store_unit_interval(scrambled_point(index, moved(seed, 3 * set), moved(seed, 3 * set + 1),
                                            moved(seed, 3 * set + 2)),
                            points + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_set);

void VertexPoints::clear() {
    size_ = 0;
}

void VertexPoints::add(std::uint32_t seed, std::uint32_t index) {
    if (size_ == seeds_.size()) {
        for (auto* row : {&seeds_, &indices_}) row->resize(2 * size_ + SobolBatch::lanes);
    }
    seeds_[size_] = seed;
    indices_[size_] = index;
    ++size_;
}

void VertexPoints::make(Sampler sampler) {
    const std::size_t whole =
        (size_ + SobolBatch::lanes - 1) / SobolBatch::lanes * SobolBatch::lanes;
    auto set = static_cast<std::uint32_t>(points_.size()) * static_cast<std::uint32_t>(decision_);
    for (std::vector<Vec2>& points : points_) {
        if (points.size() < whole) points.resize(whole);
        if (sampler == Sampler::sobol) {
            HWY_DYNAMIC_DISPATCH(make_set)
            ({seeds_.data(), indices_.data(), whole}, set, points.data());
        } else {
            for (std::size_t i = 0; i < size_; ++i) {
                points[i] = uniform_random(indices_[i], hash(seeds_[i], set));
            }
        }
        ++set;
    }
}

}  // namespace etalon
#endif
