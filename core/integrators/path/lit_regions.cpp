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

/// The direction of number i of `count` that are spread evenly over a spot's cone (Vogel 1979).
Vec3 spread_direction(const SpotSource& spot, int i, int count) {
    Vec3 x, y;
    orthonormal_basis(spot.axis, x, y);
    const double cosine = 1 - (i + 0.5) / count * (1 - spot.cos_total);
    const double sine = std::sqrt(1 - cosine * cosine), angle = i * pi * (3 - std::sqrt(5.0));
    return sine * std::cos(angle) * x + sine * std::sin(angle) * y + cosine * spot.axis;
}

/// The homogeneous medium about the camera if it scatters, else null.
const PhysicalMedium* fog_of(const PhysicalLook& look) {
    if (look.camera_medium == no_index) return nullptr;
    const PhysicalMedium& medium = look.media[look.camera_medium];
    return medium.grid || medium.scattering == Color(0.0F) ? nullptr : &medium;
}

/// The spot of most power whose cone is narrower than a half space, or null.
const SpotSource* brightest_spot(const PhysicalLook& look) {
    const SpotSource* brightest = nullptr;
    for (const PhysicalLight& light : look.lights) {
        const auto* spot = std::get_if<SpotSource>(&light);
        if (!spot || !(spot->cos_total > 0)) continue;
        const auto power = [](const SpotSource& s) {
            return luminance(s.intensity) * (1 - s.cos_total);
        };
        if (!brightest || power(*spot) > power(*brightest)) brightest = spot;
    }
    return brightest;
}

/// A ray of a beam, and how long it is.
struct BeamRay {
    double intensity, length;
    Vec3 end, normal;  ///< of the surface that it meets, on its side; 0 if there is none
};

std::vector<BeamRay> beam_rays(const SpotSource& spot, double longest, const Scene& scene,
                               const BatchIntersector& intersector) {
    std::vector<Ray> rays;
    for (int i = 0; i < rays_of_beam; ++i) {
        rays.push_back({spot.position, spread_direction(spot, i, rays_of_beam)});
    }
    std::vector<Hit> hits(rays.size());
    intersector.closest(rays, hits);
    std::vector<BeamRay> beam;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3 lit = spot.position + rays[i].direction;
        const double intensity = luminance(sample_delta_light(spot, nullptr, lit).radiance);
        const bool ends = hits[i].primitive != no_index;
        beam.push_back({intensity, ends ? hits[i].t : longest, lit, Vec3(0)});
        if (!ends) continue;
        const PhysicalSurface surface = physical_surface(scene, rays[i], hits[i]);
        beam.back().end = surface.point.position;
        beam.back().normal = surface.ng.dot(rays[i].direction) < 0 ? surface.ng : -surface.ng;
    }
    return beam;
}

/// The disk that has the points of rays that end in the plane where `first` does; its power is that
/// of light from a surface of an albedo of a quarter.
LitDisk disk_about(const BeamRay& first, const std::vector<BeamRay>& beam, double extinction) {
    constexpr double flat = 1e-3;
    double sum = 0, spread = 0;
    Vec3 centre(0);
    const auto power = [&](const BeamRay& ray) {
        const bool is_beside =
            ray.normal.dot(first.normal) > 1 - flat &&
            std::abs((ray.end - first.end).dot(first.normal)) < flat * first.length;
        return is_beside ? ray.intensity * std::exp(-extinction * ray.length) : 0;
    };
    for (const BeamRay& ray : beam) {
        sum += power(ray);
        centre += power(ray) * ray.end;
    }
    if (!(sum > 0)) return {};
    centre /= sum;
    for (const BeamRay& ray : beam) spread += power(ray) * (ray.end - centre).length2();
    return {centre, first.normal, 2 * spread / sum, static_cast<float>(sum)};
}

}  // namespace

LitRegions::LitRegions(const Scene& scene, const Lights& lights,
                       const BatchIntersector& intersector) {
    const PhysicalMedium* fog = fog_of(scene.physical());
    const SpotSource* spot = brightest_spot(scene.physical());
    if (!fog || !spot || !lights.infinite().empty()) return;
    const double extinction = luminance(fog->extinction()), scattering = luminance(fog->scattering);
    const std::vector<BeamRay> beam = beam_rays(*spot, 1 / extinction, scene, intersector);
    const double longest = std::ranges::max(beam, {}, &BeamRay::length).length;
    const double tangent = std::sqrt(1 / (spot->cos_total * spot->cos_total) - 1);
    for (std::size_t k = 0; k < count; ++k) {
        const double end = longest * std::exp2(-static_cast<double>(k)), begin = end / 2;
        centres_[k] = spot->position + (begin + end) / 2 * spot->axis;
        radii2_[k] = static_cast<float>(end * end * (1.0 / 16 + tangent * tangent));
        for (const auto& [intensity, length, lit, normal] : beam) {
            const double part = std::clamp(length, begin, end) - begin;
            powers_[k] += static_cast<float>(scattering * intensity * part *
                                             std::exp(-extinction * (begin + part / 2)));
        }
    }
    for (const BeamRay& ray : beam) {
        const LitDisk disk = disk_about(ray, beam, extinction);
        if (disk.power > disk_.power) disk_ = disk;
    }
    constexpr double most_guided = 0.25;  // by measurement
    part_ = static_cast<float>(most_guided * lights.power_share_of_spots());
}

LitRegionsFrom::LitRegionsFrom(const LitRegions& regions, const Receiver& at)
    : disk_(regions.disk_), to_disk_(disk_.centre - at.position), part_(regions.part_) {
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const Vec3 way = regions.centres_[k] - at.position;
        const auto distance2 = static_cast<float>(way.length2());
        const float radius2 = regions.radii2_[k];
        const bool is_inside = !(distance2 > radius2);
        const float sine2 = is_inside ? 1 : radius2 / distance2;
        const float scale = distance2 > 0 ? 1 / std::sqrt(distance2) : 0;
        x_[k] = static_cast<float>(way.x) * scale;
        y_[k] = static_cast<float>(way.y) * scale;
        z_[k] = static_cast<float>(way.z) * scale;
        sagitta_[k] = is_inside ? 2 : sine2 / (1 + std::sqrt(1 - sine2));
        const bool is_below =
            at.normal.dot(way) < -std::sqrt(static_cast<double>(radius2)) * at.normal.length();
        const float power = is_below ? 0 : regions.powers_[k];
        weights_[k] = power > 0 && radius2 > 0 ? power / std::max(distance2, radius2) : 0;
        sum_ += weights_[k];
    }
    const double distance2 = to_disk_.length2(), height = -to_disk_.dot(disk_.normal);
    const bool faces =
        height > 0 && disk_.radius2 > 0 &&
        (at.normal == Vec3(0) || at.normal.dot(to_disk_) > -std::sqrt(disk_.radius2));
    if (faces) {
        const double cosine =
            (height + std::sqrt(disk_.radius2) / 4) / std::sqrt(distance2 + disk_.radius2);
        disk_weight_ =
            disk_.power * static_cast<float>(cosine / std::max(distance2, disk_.radius2));
        sum_ += disk_weight_;
    }
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const auto angle = static_cast<float>(2 * pi) * sagitta_[k] * sum_;
        densities_[k] = weights_[k] > 0 ? weights_[k] / angle : 0;
    }
}

Vec3 LitRegionsFrom::sample(double choice, const Vec2& uv) const {
    const auto wanted = static_cast<float>(choice) * sum_;
    if (!(wanted < disk_weight_)) return sample_sphere(wanted - disk_weight_, uv);
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

float LitRegionsFrom::density(const Vec3& direction) const {
    const auto x = static_cast<float>(direction.x), y = static_cast<float>(direction.y),
               z = static_cast<float>(direction.z);
    float sum = 0;
    for (std::size_t k = 0; k < LitRegions::count; ++k) {
        const float cosine = x * x_[k] + y * y_[k] + z * z_[k];
        sum += cosine >= 1 - sagitta_[k] ? densities_[k] : 0;
    }
    return disk_weight_ > 0 ? sum + disk_density(direction) : sum;
}

float LitRegionsFrom::disk_density(const Vec3& direction) const {
    const double cosine = direction.dot(disk_.normal), height = to_disk_.dot(disk_.normal);
    if (!(cosine < 0)) return 0;
    const double distance = height / cosine;
    if ((distance * direction - to_disk_).length2() > disk_.radius2) return 0;
    const double by_angle = distance * distance / (pi * disk_.radius2 * -cosine);
    return static_cast<float>(by_angle) * disk_weight_ / sum_;
}

}  // namespace etalon
