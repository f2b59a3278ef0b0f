#include "core/sampling/vertex_names.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/vertex_names.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/hash-inl.h"

#ifndef ETALON_VERTEX_NAMES_ONCE
#define ETALON_VERTEX_NAMES_ONCE
namespace etalon {

/// Pointers to the columns of VertexNames.
struct VertexColumns {
    const std::uint32_t *pixels, *names, *indices;
};

/// A point of a choice: number `k` of the `parts` of each sample.
struct ChoicePart {
    std::uint32_t choice, k, parts;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Names the points, padding included.
void name_all(const VertexColumns& vertices, const ChoicePart& part, PointNames& points) {
    const Words::Tag tag;
    const auto load = [&](const std::uint32_t* from)
                          HWY_ATTR { return Words(hn::LoadU(tag, from)); };
    for (std::size_t i = 0; i < points.size(); i += hn::Lanes(tag)) {
        const Words dimension = hashed(load(vertices.names + i), Words(part.choice));
        const Words seed = hashed(load(vertices.pixels + i), dimension);
        const Words index = load(vertices.indices + i) * part.parts + part.k;
        hn::StoreU(seed.words, tag, points.seeds() + i);
        hn::StoreU(index.words, tag, points.indices() + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(name_all);

void VertexNames::name_points(std::uint32_t choice, std::uint32_t k, std::uint32_t parts,
                              PointNames& points) const {
    points.resize(size_);
    HWY_DYNAMIC_DISPATCH(name_all)
    ({pixels_.data(), names_.data(), indices_.data()}, {choice, k, parts}, points);
}

}  // namespace etalon
#endif
