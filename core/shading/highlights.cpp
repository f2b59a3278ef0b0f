#include "core/shading/highlights.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/shading/fresnel.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/highlights.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/float_power_lanes-inl.h"

#ifndef ETALON_HIGHLIGHTS_ONCE
#define ETALON_HIGHLIGHTS_ONCE
namespace etalon {
namespace {

/// Returns the highlight for shadow ray number i.
float highlight_at(const Material& material, const SeenSurfaces& surfaces, const ShadowRays& shadow,
                   std::size_t i) {
    const std::size_t j = shadow.surface(i);
    return static_cast<float>(highlight(material, surfaces.directions[j],
                                        surfaces.shading_normals[j], shadow.towards[i]));
}

/// Returns true if all shadow rays from number `first` on, before `last` and at most `count`, are
/// blocked.
bool are_blocked(const ShadowRays& shadow, std::size_t first, std::size_t last, std::size_t count) {
    const auto from = shadow.blocked.begin() + static_cast<std::ptrdiff_t>(first);
    return std::all_of(from, from + static_cast<std::ptrdiff_t>(std::min(last - first, count)),
                       [](std::uint8_t is_blocked) { return is_blocked != 0; });
}

}  // namespace
}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Numbers of the surfaces of some shadow rays, ascending; unused lanes repeat the last one.
struct SurfaceNumbers {
    SurfaceNumbers(const ShadowRays& shadow, std::size_t first, std::size_t last) {
        const std::size_t end = std::min(last - first, lanes) - 1;
        for (std::size_t k = 0; k < lanes; ++k) {
            numbers[k] = shadow.surface(first + std::min(k, end));
        }
        are_consecutive = numbers[end] - numbers[0] == end;
    }

    /// Loads the vectors of those numbers, which nearly always are consecutive.
    HWY_INLINE Vec3Lanes load_from(const Vec3Buffer& column) const {
        if (are_consecutive) return load(column.span(), numbers[0]);
        Vec3Columns<most_doubles> vectors;
        for (std::size_t k = 0; k < lanes; ++k) vectors.set(k, column[numbers[k]]);
        return load(vectors.span(), 0);
    }

    static constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
    std::array<std::size_t, lanes> numbers;
    bool are_consecutive;
};

/// Computes highlight_cosine() for several rays with the same operations.
HWY_INLINE Doubles highlight_cosines(Highlight model, const Vec3Lanes& direction,
                                     const Vec3Lanes& normal, const Vec3Lanes& towards) {
    if (model == Highlight::blinn) return normal.dot(normalized(towards - direction));
    return (direction - (broadcast(2) * direction.dot(normal)) * normal).dot(towards);
}

/// Sets as many values as vectors have lanes. Returns a mask of those that are uncertain.
std::uint32_t set_highlights(const Material& material, const SeenSurfaces& surfaces,
                             const ShadowRays& shadow, std::size_t first, std::size_t last,
                             PaddedColumn<float>& values) {
    const SurfaceNumbers numbers(shadow, first, last);
    const FloatPowers powers =
        float_powers(highlight_cosines(material.highlight, numbers.load_from(surfaces.directions),
                                       numbers.load_from(surfaces.shading_normals),
                                       load(shadow.towards.span(), first)),
                     material.shininess);
    const hn::Rebind<float, DoubleTag> floats;
    hn::StoreU(hn::DemoteTo(floats, powers.values), floats, &values[first]);
    std::uint8_t uncertain = 0;
    hn::StoreMaskBits(DoubleTag(), hn::Not(powers.certain), &uncertain);
    return uncertain & ((1U << std::min(last - first, hn::Lanes(DoubleTag()))) - 1);
}

void find(const Material& material, const SeenSurfaces& surfaces, const ShadowRays& shadow,
          std::size_t first, std::size_t last, PaddedColumn<float>& values) {
    const std::size_t lanes = hn::Lanes(DoubleTag());
    for (std::size_t i = first; i < last; i += lanes) {
        if (are_blocked(shadow, i, last, lanes)) continue;
        std::uint32_t left = set_highlights(material, surfaces, shadow, i, last, values);
        for (; left != 0; left &= left - 1) {
            const std::size_t k = i + std::countr_zero(left);
            values[k] = highlight_at(material, surfaces, shadow, k);
        }
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(find);

namespace {

double highlight_cosine(Highlight model, const Vec3& direction, const Vec3& normal,
                        const Vec3& towards) {
    if (model == Highlight::blinn) return normal.dot(normalized(towards - direction));
    return reflect(direction, normal).dot(towards);
}

}  // namespace

double highlight(const Material& material, const Vec3& direction, const Vec3& normal,
                 const Vec3& towards) {
    const double cosine = highlight_cosine(material.highlight, direction, normal, towards);
    if (!(cosine > 0) && material.shininess > 0) return 0;
    return std::pow(std::max(0.0, cosine), material.shininess);
}

void find_highlights(const Material& material, const SeenSurfaces& surfaces,
                     const ShadowRays& shadow, std::size_t first, std::size_t last,
                     PaddedColumn<float>& values) {
    if (material.shininess > 0) {
        return HWY_DYNAMIC_DISPATCH(find)(material, surfaces, shadow, first, last, values);
    }
    for (std::size_t i = first; i < last; ++i)
        values[i] = highlight_at(material, surfaces, shadow, i);
}

}  // namespace etalon
#endif
