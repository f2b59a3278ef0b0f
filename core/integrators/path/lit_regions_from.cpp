#include "core/integrators/path/lit_regions_from.h"

#include <algorithm>
#include <numbers>

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns whether some of a ball is not below the horizon of a receiver, if it has one.
bool is_above(const Receiver& at, const Vec3& to_centre, double radius) {
    return at.normal == Vec3(0) || at.normal.dot(to_centre) > -radius;
}

}  // namespace

LitRegionsFrom::LitRegionsFrom(const LitRegions& regions, const Receiver& at)
    : disk_(regions.disk()), to_disk_(disk_.centre - at.position), part_(regions.part()) {
    see_spheres(regions.spheres(), at);
    see(disk_, at);
    for (std::size_t k = 0; k < LitSpheres::count; ++k) {
        const float solid_angle = static_cast<float>(2 * pi) * sagitta_[k];
        densities_[k] = weights_[k] > 0 ? weights_[k] / (solid_angle * sum_) : 0;
    }
}

/// Without branches, so that all spheres are processed in SIMD lanes.
void LitRegionsFrom::see_spheres(const LitSpheres& spheres, const Receiver& at) {
    const Vec3& p = at.position;
    const auto nx = static_cast<float>(at.normal.x), ny = static_cast<float>(at.normal.y),
               nz = static_cast<float>(at.normal.z);
    for (std::size_t k = 0; k < LitSpheres::count; ++k) {
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

void LitRegionsFrom::see(const LitDisk& disk, const Receiver& at) {
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
    for (std::size_t k = 0; k < LitSpheres::count; ++k) {
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
    for (std::size_t k = 0; k < LitSpheres::count; ++k) {
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
