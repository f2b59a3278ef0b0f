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

/// Finds the weights of the rays that leave surface number i of the chunk, which is glass. With
/// `always_mirrors` a mirrored ray is traced even if its weight is 0.
void weigh_glass(const Material& m, const LeavingRays& leaving, std::size_t i, bool always_mirrors,
                 WeightedRays& mirrored, WeightedRays& refracted) {
    Color reflection = m.reflection, transmission = m.transmission;
    if (m.fresnel) {
        const double reflectance = leaving.reflectance(i);
        reflection *= static_cast<float>(reflectance);
        transmission *= static_cast<float>(1 - reflectance);
    }
    if (leaving.is_total(i)) transmission = Color(0.0F);
    if (!is_black(reflection) || always_mirrors) mirrored.add(i, reflection);
    if (!is_black(transmission)) refracted.add(i, transmission);
}

/// The surfaces of a batch, the paths of the rays that hit them, and whether those that leave them
/// need names of their own.
struct SeenRays {
    const SeenSurfaces& surfaces;
    std::span<const RayPath> paths;
    bool names;
};

/// Appends path, surface and weight of the rays that leave surfaces from number `first` on, but not
/// the rays themselves. Returns the number of rays.
std::size_t append(const WeightedRays& some, bool crosses, const SeenRays& seen, std::size_t first,
                   SecondaryRays& to) {
    std::size_t at = to.count;
    for (LeavingRays::Choice left = some.choice; left != 0; left &= left - 1, ++at) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left)), j = first + i;
        const SeenSurfaces::Traits& traits = seen.surfaces.traits[j];
        RayPath path = seen.paths[traits.ray];
        if (seen.names) path.name = ray_name(path.name, crosses);
        if (crosses) {
            path.absorption = seen.surfaces.entering(j) ? traits.material->absorption : Color(0.0F);
        }
        to.paths[at] = path;
        to.surfaces[at] = static_cast<std::uint32_t>(j);
        to.weights[at] = PaddedColor(some.weights[i]);
    }
    const std::size_t number = at - to.count;
    to.count = at;
    return number;
}

}  // namespace

/// Works chunk by chunk; the mirrored rays of a chunk come before its refracted ones.
void SecondaryRays::find(const SeenSurfaces& seen, std::span<const RayPath> seen_by,
                         const WhittedRules& rules, bool names, RayCounts& counts) {
    const SeenRays seen_rays{seen, seen_by, names};
    const std::size_t most = 2 * seen.size();
    count = 0;
    rays.make_room(most);
    paths.make_room(most);
    surfaces.make_room(most);
    weights.make_room(most);
    LeavingRays leaving(seen, {rules.schlick, rules.fixed_bias});
    for (std::size_t first = 0, made = 0; first < seen.size(); first += made) {
        made = leaving.make(first);
        WeightedRays mirrored, refracted;
        for (LeavingRays::Choice left = leaving.active(); left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            const Material& m = *seen.traits[first + i].material;
            if (seen.is_glass(first + i)) {
                weigh_glass(m, leaving, i, rules.mirror_all_glass, mirrored, refracted);
            } else {
                mirrored.add(i, m.reflection);
            }
        }
        leaving.put_mirrored(mirrored.choice, rays, count);
        counts.reflected += append(mirrored, false, seen_rays, first, *this);
        leaving.put_refracted(refracted.choice, rays, count);
        counts.refracted += append(refracted, true, seen_rays, first, *this);
    }
}

}  // namespace etalon
