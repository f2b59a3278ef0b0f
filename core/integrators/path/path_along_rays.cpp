// Light of point lights that media scatter along a ray.
#include "core/integrators/path/path_batch.h"
#include "core/medium/homogeneous.h"
#include "core/sampling/dimensions.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

/// Samples a point light at a point of the ray that depends on the light, in addition to the ends
/// of flights. The balance heuristic weights the two strategies (Veach 1997).
template <bool in_media>
void PathBatch<in_media>::sample_along(std::size_t ray, const RaySegment& segment,
                                       const Vec2& choices) {
    const Path& path = paths_[ray];
    const auto pick = shared_.lights.pick_point_light(choices.y);
    const auto range =
        shared_.lights.lit_range(pick.light, segment.origin, segment.direction, segment.length);
    if (!range) return;
    const double distance = range->sample(choices.x);
    const double along = pick.probability * range->density(distance);
    const Vec3 position = segment.point(distance);
    const LightSample light = shared_.lights.sample(pick.light, position, Vec2(0));
    if (!(light.pdf > 0) || light.radiance == Color(0.0F) || !(along > 0)) return;
    const PhysicalMedium& medium = shared_.scene.physical().media[media_[ray]];
    Receiver at{position};
    if (!shared_.samples_all) shared_.lights.pick(at, 0);
    const double flown = flight_density(medium, path.throughput, distance) *
                         shared_.expected_samples(at, pick.light);
    const Color scattered = transmittance(medium.extinction(), distance) * medium.scattering *
                            shared_.media.phase(media_[ray]).value(segment.direction.dot(light.wi));
    Ray shadow{position, light.target - position};
    shadow.tmax = shadow_end;
    shadow.set_time(rays_[ray].time());
    shadow.set_shadow();
    shadow_rays_.push_back(shadow);
    shadow_media_.push_back(
        {media_[ray], path.source.sequence(along_ray_collision_dimension(path.name))});
    light_contributions_.push_back({path.sample, path.throughput * scattered * light.radiance *
                                                     static_cast<float>(1 / (along + flown))});
}

/// Returns the share of a light's samples at the ends of flights, beside those of sample_along().
template <bool in_media>
float PathBatch<in_media>::flight_share(const MediumVertex& at, const LightQuery& query) const {
    if (at.density == 0) return 1;
    const auto range = shared_.lights.lit_range(query.light, at.flight.origin, at.flight.direction,
                                                at.flight.length);
    if (!range) return 1;
    const double distance = (at.position - at.flight.origin).dot(at.flight.direction);
    const double flown = at.density * query.expected_samples;
    const double along =
        shared_.lights.point_light_probability(query.light) * range->density(distance);
    return static_cast<float>(flown / (flown + along));
}

template float PathBatch<false>::flight_share(const MediumVertex&, const LightQuery&) const;
template float PathBatch<true>::flight_share(const MediumVertex&, const LightQuery&) const;
template void PathBatch<true>::sample_along(std::size_t, const RaySegment&, const Vec2&);

}  // namespace etalon
