#include "core/integrators/whitted/secondary_rays.h"

#include <array>
#include <bit>

#include "core/sampling/dimensions.h"
#include "core/shading/leaving_rays.h"

namespace etalon {
namespace {

bool is_black(const Color& c) {
    return c == Color(0.0F);
}

/// The rays of one kind, mirrored or refracted, that leave the surfaces of a chunk: which surfaces
/// have one, and its weight.
struct WeightedRays {
    LeavingRays::Choice choice = 0;
    std::array<Color, LeavingRays::most> weights;

    void add(std::size_t i, const Color& weight) {
        choice |= LeavingRays::Choice{1} << i;
        weights[i] = weight;
    }
};

/// Finds the weights of the rays that leave surface number i of the chunk. With `all_glass_mirrors`
/// a mirrored ray is traced even if its weight is 0.
void weigh(const Material& m, const LeavingRays& leaving, std::size_t i, bool all_glass_mirrors,
           WeightedRays& mirrored, WeightedRays& refracted) {
    const bool counted = all_glass_mirrors && !is_black(m.transmission);
    Color reflection = m.reflection, transmission = m.transmission;
    if (!is_black(m.transmission)) {
        if (m.fresnel) {
            const double reflectance = leaving.reflectance(i);
            reflection *= static_cast<float>(reflectance);
            transmission *= static_cast<float>(1 - reflectance);
        }
        if (leaving.is_total(i)) transmission = Color(0.0F);
    }
    if (!is_black(reflection) || counted) mirrored.add(i, reflection);
    if (!is_black(transmission)) refracted.add(i, transmission);
}

/// Appends path, surface and weight of the rays that leave surfaces from number `first` on, but not
/// the rays themselves. Returns the number of rays.
std::size_t append(const WeightedRays& some, bool crosses, const SeenSurfaces& surfaces,
                   std::size_t first, std::span<const RayPath> seen_by, SecondaryRays& to) {
    for (LeavingRays::Choice left = some.choice; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left)), j = first + i;
        const SeenSurfaces::Traits& traits = surfaces.traits[j];
        const RayPath& path = seen_by[traits.ray];
        Color within = path.absorption;
        if (crosses) within = surfaces.entering(j) ? traits.material->absorption : Color(0.0F);
        to.paths.push_back({path.sample, ray_name(path.name, crosses), within});
        to.surfaces.push_back(static_cast<std::uint32_t>(j));
        to.weights.push_back(some.weights[i]);
    }
    return static_cast<std::size_t>(std::popcount(some.choice));
}

}  // namespace

/// Works chunk by chunk; the mirrored rays of a chunk come before its refracted ones.
void SecondaryRays::find(const SeenSurfaces& seen, std::span<const RayPath> seen_by,
                         const WhittedRules& rules, RayCounts& counts) {
    paths.clear();
    surfaces.clear();
    weights.clear();
    rays.make_room(2 * seen.size());
    LeavingRays leaving(seen, {rules.schlick, rules.fixed_bias});
    for (std::size_t first = 0, count = 0; first < seen.size(); first += count) {
        count = leaving.make(first);
        WeightedRays mirrored, refracted;
        for (LeavingRays::Choice left = leaving.active(); left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            weigh(*seen.traits[first + i].material, leaving, i, rules.mirror_all_glass, mirrored,
                  refracted);
        }
        leaving.put_mirrored(mirrored.choice, rays, paths.size());
        counts.reflected += append(mirrored, false, seen, first, seen_by, *this);
        leaving.put_refracted(refracted.choice, rays, paths.size());
        counts.refracted += append(refracted, true, seen, first, seen_by, *this);
    }
}

}  // namespace etalon
