#include "core/integrators/path/light_along_rays.h"

#include "core/medium/homogeneous.h"
#include "core/sampling/dimensions.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

void sample_light_along(const PathScene& scene, const PathState& path, const MediumSegment& along,
                        const Vec2& choices, ShadowQueue& shadows) {
    const RaySegment& segment = along.segment;
    const auto pick = scene.lights.pick_point_light(choices.y);
    const auto range =
        scene.lights.lit_range(pick.light, segment.origin, segment.direction, segment.length);
    if (!range) return;
    const double distance = range->sample(choices.x);
    const double asked = pick.probability * range->density(distance);
    const Vec3 position = segment.point(distance);
    const LightSample light = scene.lights.sample(pick.light, position, Vec2(0));
    if (!(light.pdf > 0) || light.radiance == Color(0.0F) || !(asked > 0)) return;
    const PhysicalMedium& medium = scene.scene.physical().media[along.medium];
    Receiver at{position};
    if (!scene.samples_all) scene.lights.pick(at, 0);
    const double flown =
        flight_density(medium, path.throughput, distance) * scene.expected_samples(at, pick.light);
    const Color scattered = transmittance(medium.extinction(), distance) * medium.scattering *
                            scene.media.phase(along.medium).value(segment.direction.dot(light.wi));
    Ray shadow{position, light.target - position};
    shadow.tmax = shadow_end;
    shadow.set_time(along.time);
    shadows.add(shadow,
                {path.sample, path.throughput * scattered * light.radiance *
                                  static_cast<float>(1 / (asked + flown))},
                {along.medium, path.source.sequence(along_ray_collision_dimension(path.name))});
}

float share_of_flights(const PathScene& scene, const MediumVertex& at, std::uint32_t light,
                       float expected_samples) {
    if (at.density == 0) return 1;
    const auto range =
        scene.lights.lit_range(light, at.flight.origin, at.flight.direction, at.flight.length);
    if (!range) return 1;
    const double distance = (at.position - at.flight.origin).dot(at.flight.direction);
    const double flown = at.density * expected_samples;
    const double asked = scene.lights.point_light_probability(light) * range->density(distance);
    return static_cast<float>(flown / (flown + asked));
}

}  // namespace etalon
