#include "core/integrators/path/lit_regions.h"

#include <algorithm>
#include <numbers>

#include "core/light/delta_lights.h"
#include "core/numerics/luminance.h"
#include "core/shading/physical_surface.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int rays_of_beam = 256;

/// A ray of a spotlight's beam with its length.
struct BeamRay {
    double intensity, length;
    Vec3 end, normal;  ///< of the surface that it hits, on its side; 0 if it misses
};

struct Beam {
    const SpotSource& spot;
    double extinction, scattering;  ///< coefficients of the medium
    std::vector<BeamRay> rays;
};

struct LitSphere {
    Vec3 centre;
    float radius, power;
};

/// Returns direction number i of `count` that are spread evenly over a spotlight's cone (Vogel
/// 1979).
Vec3 spread_direction(const SpotSource& spot, int i, int count) {
    Vec3 x, y;
    orthonormal_basis(spot.axis, x, y);
    const double cosine = 1 - (i + 0.5) / count * (1 - spot.cos_total);
    const double sine = std::sqrt(1 - cosine * cosine), angle = i * pi * (3 - std::sqrt(5.0));
    return sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * spot.axis;
}

/// Returns the homogeneous medium about the camera if it scatters, else null.
const PhysicalMedium* fog_of(const PhysicalLook& look) {
    if (look.camera_medium == no_index) return nullptr;
    const PhysicalMedium& medium = look.media[look.camera_medium];
    return medium.grid || medium.scattering == Color(0.0F) ? nullptr : &medium;
}

/// Returns the spotlight of most power with a narrow cone, or null.
const SpotSource* brightest_spot(const PhysicalLook& look) {
    constexpr double narrow = 0.7;
    const auto power = [](const SpotSource& spot) {
        return luminance(spot.intensity) * (1 - spot.cos_total);
    };
    const SpotSource* brightest = nullptr;
    for (const PhysicalLight& light : look.lights) {
        const auto* spot = std::get_if<SpotSource>(&light);
        if (!spot || spot->cos_total < narrow) continue;
        if (!brightest || power(*spot) > power(*brightest)) brightest = spot;
    }
    return brightest;
}

/// Traces rays of a spotlight to a surface, or over a distance of `range` if they miss.
std::vector<BeamRay> trace(const SpotSource& spot, double range, const Scene& scene,
                           const BatchIntersector& intersector) {
    std::vector<Ray> rays;
    rays.reserve(rays_of_beam);
    for (int i = 0; i < rays_of_beam; ++i) {
        rays.push_back({spot.position, spread_direction(spot, i, rays_of_beam)});
    }
    std::vector<Hit> hits(rays.size());
    intersector.closest(rays, hits);
    std::vector<BeamRay> beam;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3 lit = spot.position + range * rays[i].direction;
        const double intensity = luminance(sample_delta_light(spot, nullptr, lit).radiance);
        beam.push_back({intensity * range * range, range, lit, Vec3(0)});
        if (hits[i].primitive == no_index) continue;
        const PhysicalSurface at = physical_surface(scene, rays[i], hits[i]);
        beam.back().length = hits[i].t;
        beam.back().end = at.point.position;
        beam.back().normal = at.ng.dot(rays[i].direction) < 0 ? at.ng : -at.ng;
    }
    return beam;
}

/// Returns the sphere around the beam from half the distance `end` to `end`; its power is that of
/// the light scattered there.
LitSphere sphere_around(const Beam& beam, double end) {
    const double begin = end / 2, cosine = beam.spot.cos_total;
    double power = 0;
    for (const BeamRay& ray : beam.rays) {
        const double part = std::clamp(ray.length, begin, end) - begin;
        power += beam.scattering * part * ray.intensity *
                 std::exp(-beam.extinction * (begin + part / 2));
    }
    const double tangent2 = 1 / (cosine * cosine) - 1;
    return {beam.spot.position + (begin + end) / 2 * beam.spot.axis,
            static_cast<float>(end * std::sqrt(1.0 / 16 + tangent2)), static_cast<float>(power)};
}

/// Returns a disk as large as the spread of the rays that end in the plane where `first` does; its
/// power is that of light from a surface with an albedo of a quarter.
LitDisk disk_about(const Beam& beam, const BeamRay& first) {
    constexpr double flat = 1e-3;
    const auto power = [&](const BeamRay& ray) {
        const bool is_beside =
            ray.normal.dot(first.normal) > 1 - flat &&
            std::abs((ray.end - first.end).dot(first.normal)) < flat * first.length;
        return is_beside ? ray.intensity * std::exp(-beam.extinction * ray.length) : 0;
    };
    double sum = 0, spread = 0;
    Vec3 centre(0);
    for (const BeamRay& ray : beam.rays) {
        sum += power(ray);
        centre += power(ray) * ray.end;
    }
    if (!(sum > 0)) return {};
    centre /= sum;
    for (const BeamRay& ray : beam.rays) spread += power(ray) * (ray.end - centre).length2();
    return {centre, first.normal, 2 * spread / sum, static_cast<float>(sum)};
}

}  // namespace

LitRegions::LitRegions(const Scene& scene, const Lights& lights,
                       const BatchIntersector& intersector) {
    const PhysicalMedium* fog = fog_of(scene.physical());
    const SpotSource* spot = brightest_spot(scene.physical());
    if (!fog || !spot || !lights.infinite().empty()) return;
    const double extinction = luminance(fog->extinction());
    const Beam beam{*spot, extinction, luminance(fog->scattering),
                    trace(*spot, 1 / extinction, scene, intersector)};
    double end = std::ranges::max(beam.rays, {}, &BeamRay::length).length;
    for (std::size_t k = 0; k < LitSpheres::count; ++k) {
        const LitSphere sphere = sphere_around(beam, end);
        spheres_.x[k] = sphere.centre.x;
        spheres_.y[k] = sphere.centre.y;
        spheres_.z[k] = sphere.centre.z;
        spheres_.radius[k] = sphere.radius;
        spheres_.power[k] = sphere.power;
        end /= 2;
    }
    for (const BeamRay& ray : beam.rays) {
        const LitDisk disk = disk_about(beam, ray);
        if (disk.power > disk_.power) disk_ = disk;
    }
    constexpr double most_guided = 0.25;  // by measurement
    part_ = static_cast<float>(most_guided * lights.power_share_of_spots());
}

}  // namespace etalon
