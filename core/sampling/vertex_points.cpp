#include "core/sampling/vertex_points.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/vertex_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/sobol-inl.h"

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
void make_set(const PointNames& names, std::uint32_t set, Vec2* points) {
    const Words::Tag tag;
    const auto moved = [](Words seed, std::uint32_t times)
                           HWY_ATTR { return mixed(seed + times * 0x9e3779b9U); };
    for (std::size_t i = 0; i < names.size(); i += hn::Lanes(tag)) {
        const Words seed(hn::LoadU(tag, names.seeds() + i)),
            index(hn::LoadU(tag, names.indices() + i));
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

void VertexPoints::make(Sampler sampler) {
    auto set = static_cast<std::uint32_t>(points_.size()) * static_cast<std::uint32_t>(decision_);
    for (std::vector<Vec2>& points : points_) {
        if (points.size() < names_.padded_size()) points.resize(names_.padded_size());
        if (sampler == Sampler::sobol) {
            HWY_DYNAMIC_DISPATCH(make_set)
            (names_, set, points.data());
        } else {
            for (std::size_t i = 0; i < names_.size(); ++i) {
                points[i] = uniform_random(names_.indices()[i], hash(names_.seeds()[i], set));
            }
        }
        ++set;
    }
}

}  // namespace etalon
#endif
