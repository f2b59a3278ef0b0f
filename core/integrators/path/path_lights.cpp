// The light that paths hit, and that their vertices sample.
#include "core/integrators/path/light_along_rays.h"
#include "core/integrators/path/path_batch.h"
#include "core/integrators/path/path_directions.h"
#include "core/sampling/dimensions.h"
#include "core/shading/shadow_rays.h"

namespace etalon {
namespace {

/// Returns the weight of a direction sampled with density `a` that another strategy would have
/// sampled with `b` (power heuristic: Veach 1997, section 9.2).
float power_weight(float a, float b) {
    const float ratio = b / a;  // whose square is finite, or the weight is 0
    return 1 / (1 + ratio * ratio);
}

/// The same for lights whose density is compensated (balance heuristic: Karlik et al. 2019).
float balance_weight(float a, float b) {
    return a / (a + b);
}

}  // namespace

template <bool in_media>
void PathBatch<in_media>::add_escaped(const PathState& path, const Vec3& direction) {
    if (path.is_unlit) return;
    for (const std::uint32_t light : shared_.lights.infinite()) {
        const InfiniteLight& infinite = shared_.lights.infinite_light(light);
        const Color radiance = infinite.radiance(direction);
        float weight = 1;
        if (!path.specular && infinite.can_be_sampled()) {
            const double asked =
                shared_.expected_samples(path.last, light) * infinite.pdf(direction);
            weight = balance_weight(path.density, static_cast<float>(asked));
        }
        add(path, weight * radiance);
    }
}

template <bool in_media>
void PathBatch<in_media>::add_emitted(const PathState& path, const PhysicalSurface& at,
                                      const Vec3& direction) {
    const SurfaceBinding& binding = *at.binding;
    if (binding.light == no_index || path.is_unlit) return;
    const std::uint32_t light = shared_.lights.number_of(binding.light, at.point.primitive);
    const Color radiance = shared_.lights.emitted(light, at.point, direction);
    if (radiance == Color(0.0F)) return;
    float weight = 1;
    if (!path.specular) {
        const double asked = shared_.expected_samples(path.last, light) *
                             shared_.lights.pdf(light, path.last.position, at.point);
        weight = power_weight(path.density, static_cast<float>(asked));
    }
    add(path, weight * radiance);
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::sample_lights(PathState& path, const Vertex& at) {
    if (!shared_.samples_all) {
        const std::size_t number = at.numbers.vertex;
        const auto pick = shared_.lights.pick(path.last, points_.light_choice(number));
        if (!pick) return;
        sample_light(
            path, at,
            {pick->light, static_cast<float>(pick->probability), points_.on_light(number), 0});
        return;
    }
    const auto on_lights = points_.on_all_lights(at.numbers.vertex);
    std::size_t next = 0;
    for (std::uint32_t light = 0; light < shared_.lights.size(); ++light) {
        const int samples = shared_.lights.samples(light);
        for (int k = 0; k < samples; ++k) {
            sample_light(path, at, {light, static_cast<float>(samples), on_lights[next], next});
            ++next;
        }
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::sample_light(const PathState& path, const Vertex& at,
                                       const LightQuery& query) {
    const LightSample light = shared_.lights.sample(query.light, path.last.position, query.uv);
    if (!(light.pdf > 0) || light.radiance == Color(0.0F)) return;
    const Evaluation scattered = at.evaluate(light.wi);
    if (scattered.f == Color(0.0F)) return;

    const float asked = query.expected_samples * light.pdf;
    float weight = 1;
    if (!light.is_delta) {
        const float scattered_density =
            at.expected_paths() * density_of<in_media>(at, light.wi, scattered.pdf);
        weight = light.at_infinity ? balance_weight(asked, scattered_density)
                                   : power_weight(asked, scattered_density);
    }
    if constexpr (std::is_same_v<Vertex, MediumVertex>) {
        if (light.is_delta && !light.at_infinity) {
            weight = share_of_flights(shared_, at, query.light, query.expected_samples);
        }
    }
    const float cosine = at.cosine(light.wi);
    const Color color = scattered.f * light.radiance * (cosine * weight / asked);
    Ray ray = light.at_infinity ? at.ray(light.wi) : at.ray_to(light.target);
    if (!light.at_infinity) ray.tmax = shadow_end;
    const LightContribution contribution{path.sample, path.throughput * color};
    if constexpr (in_media) {
        if (light.at_infinity && light.is_delta) ray.tmax = 2 * shared_.lights.scene_radius();
        shadows_.add(ray, contribution,
                     {at.medium_towards(light.wi),
                      path.source.sequence(shadow_collision_dimension(path.name, query.number))});
    } else {
        shadows_.add(ray, contribution);
    }
}

template void PathBatch<false>::add_escaped(const PathState&, const Vec3&);
template void PathBatch<true>::add_escaped(const PathState&, const Vec3&);
template void PathBatch<false>::add_emitted(const PathState&, const PhysicalSurface&, const Vec3&);
template void PathBatch<true>::add_emitted(const PathState&, const PhysicalSurface&, const Vec3&);
template void PathBatch<false>::sample_lights(PathState&, const SurfaceVertex&);
template void PathBatch<true>::sample_lights(PathState&, const SurfaceVertex&);
template void PathBatch<false>::sample_lights(PathState&, const MediumVertex&);
template void PathBatch<true>::sample_lights(PathState&, const MediumVertex&);

}  // namespace etalon
