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

/// Returns whether some of a ball is not below the horizon of a receiver, if it has one.
bool is_above(const Receiver& at, const Vec3& to_centre, double radius) {
    return at.normal == Vec3(0) || at.normal.dot(to_centre) > -radius;
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
    for (std::size_t k = 0; k < count; ++k) {
        const Sphere sphere = sphere_around(beam, end);
        spheres_.x[k] = sphere.centre.x;
        spheres_.y[k] = sphere.centre.y;
        spheres_.z[k] = sphere.centre.z;
        spheres_.radius[k] = sphere.radius;
        spheres_.power[k] = sphere.power;
        end /= 2;
    }
    for (const BeamRay& ray : beam.rays) {
        const Disk disk = disk_about(beam, ray);
        if (disk.power > disk_.power) disk_ = disk;
    }
    constexpr double most_guided = 0.25;  // by measurement
    part_ = static_cast<float>(most_guided * lights.power_share_of_spots());
}

/// Traces rays of a spotlight to a surface, or over a distance of `range` if they miss.
std::vector<LitRegions::BeamRay> LitRegions::trace(const SpotSource& spot, double range,
                                                   const Scene& scene,
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
LitRegions::Sphere LitRegions::sphere_around(const Beam& beam, double end) {
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
LitRegions::Disk LitRegions::disk_about(const Beam& beam, const BeamRay& first) {
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

LitRegionsFrom::LitRegionsFrom(const LitRegions& regions, const Receiver& at)
    : disk_(regions.disk_), to_disk_(disk_.centre - at.position), part_(regions.part_) {
    see_spheres(regions.spheres_, at);
    see(disk_, at);
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const float solid_angle = static_cast<float>(2 * pi) * sagitta_[k];
        densities_[k] = weights_[k] > 0 ? weights_[k] / (solid_angle * sum_) : 0;
    }
}

/// Without branches, so that all spheres are processed in SIMD lanes.
void LitRegionsFrom::see_spheres(const LitRegions::Spheres& spheres, const Receiver& at) {
    const Vec3& p = at.position;
    const auto nx = static_cast<float>(at.normal.x), ny = static_cast<float>(at.normal.y),
               nz = static_cast<float>(at.normal.z);
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const auto x = static_cast<float>(spheres.x[k] - p.x),
                   y = static_cast<float>(spheres.y[k] - p.y),
                   z = static_cast<float>(spheres.z[k] - p.z);
        const float distance2 = x * x + y * y + z * z, radius = spheres.radius[k];
        const float radius2 = radius * radius;
        const bool is_outside = distance2 > radius2;
        const float scale = is_outside ? 1 / std::sqrt(distance2) : 0;
        x_[k] = x * scale;
        y_[k] = y * scale;
        z_[k] = is_outside ? z * scale : 1;
        const float sine2 = radius2 * scale * scale;
        const float outside = sine2 / (1 + std::sqrt(std::max(1 - sine2, 0.0F)));
        sagitta_[k] = is_outside ? outside : 2;
        // A sphere below the horizon of a receiver, if that has one, is not visible.
        const float above = nx * x + ny * y + nz * z;
        const bool is_seen = (nx == 0 && ny == 0 && nz == 0) || above > -radius;
        weights_[k] = is_seen ? spheres.power[k] / std::max(distance2, radius2) : 0;
    }
    for (const float weight : weights_) sum_ += weight;
}

void LitRegionsFrom::see(const LitRegions::Disk& disk, const Receiver& at) {
    const double height = -to_disk_.dot(disk.normal), distance2 = to_disk_.length2();
    const double radius = std::sqrt(disk.radius2);
    constexpr double flat = 1e-3;  // of the radius: for a disk seen from its own plane
    if (!(height > flat * radius) || !is_above(at, to_disk_, radius)) return;
    // From near by some of the disk is seen under larger cosines than its centre.
    const double cosine = (height + radius / 4) / std::sqrt(distance2 + disk.radius2);
    disk_weight_ = static_cast<float>(disk.power * cosine / std::max(distance2, disk.radius2));
    sum_ += disk_weight_;
}

Vec3 LitRegionsFrom::sample(double choice, const Vec2& uv) const {
    const float wanted = static_cast<float>(choice) * sum_;
    return wanted < disk_weight_ ? sample_disk(uv) : sample_sphere(wanted - disk_weight_, uv);
}

Vec3 LitRegionsFrom::sample_disk(const Vec2& uv) const {
    Vec3 x, y;
    orthonormal_basis(disk_.normal, x, y);
    const double radius = std::sqrt(uv.x * disk_.radius2), angle = 2 * pi * uv.y;
    return normalized(to_disk_ + radius * std::cos(angle) * x + radius * std::sin(angle) * y);
}

Vec3 LitRegionsFrom::sample_sphere(float wanted, const Vec2& uv) const {
    std::size_t chosen = 0;
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        if (!(weights_[k] > 0)) continue;
        chosen = k;
        if ((wanted -= weights_[k]) < 0) break;
    }
    const Vec3 axis = normalized(Vec3(x_[chosen], y_[chosen], z_[chosen]));
    Vec3 x, y;
    orthonormal_basis(axis, x, y);
    const double sagitta = uv.x * sagitta_[chosen], angle = 2 * pi * uv.y;
    const double sine = std::sqrt(std::max(0.0, sagitta * (2 - sagitta)));
    return normalized(sine * std::cos(angle) * x + sine * std::sin(angle) * y +
                      (1 - sagitta) * axis);
}

/// An axis is of length 1 up to 3e-7, and the squared distance has a relative error of 4e-7. The
/// limit leaves room for both, since without a density a direction sampled at a narrow cone's edge
/// would weigh as much as if few were sampled there.
float LitRegionsFrom::density(const Vec3& direction) const {
    constexpr float twice = 2 + 2e-6F, room = 1e-13F;
    const Vec3f rounded(direction), rest(direction - Vec3(rounded));
    float sum = 0;
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const float dx = rounded.x - x_[k] + rest.x, dy = rounded.y - y_[k] + rest.y,
                    dz = rounded.z - z_[k] + rest.z;
        const float distance2 = dx * dx + dy * dy + dz * dz;
        sum += distance2 <= twice * sagitta_[k] + room ? densities_[k] : 0;
    }
    return disk_weight_ > 0 ? sum + disk_density(direction) : sum;
}

float LitRegionsFrom::disk_density(const Vec3& direction) const {
    const double cosine = direction.dot(disk_.normal);
    if (!(cosine < 0)) return 0;
    const double distance = to_disk_.dot(disk_.normal) / cosine;
    if ((distance * direction - to_disk_).length2() > disk_.radius2) return 0;
    const double by_angle = distance * distance / (pi * disk_.radius2 * -cosine);
    return static_cast<float>(by_angle) * disk_weight_ / sum_;
}

}  // namespace etalon
