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
    : spheres_(regions.spheres(), at),
      disk_(regions.disk()),
      to_disk_(disk_.centre - at.position),
      part_(regions.part()) {
    for (const float weight : spheres_.weights) sum_ += weight;
    see(disk_, at);
    spheres_.share(sum_);
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
        if (!(spheres_.weights[k] > 0)) continue;
        chosen = k;
        if ((wanted -= spheres_.weights[k]) < 0) break;
    }
    const Vec3 axis = normalized(Vec3(spheres_.x[chosen], spheres_.y[chosen], spheres_.z[chosen]));
    Vec3 x, y;
    orthonormal_basis(axis, x, y);
    const double sagitta = uv.x * spheres_.sagitta[chosen], angle = 2 * pi * uv.y;
    const double sine = std::sqrt(std::max(0.0, sagitta * (2 - sagitta)));
    return normalized(sine * std::cos(angle) * x + sine * std::sin(angle) * y +
                      (1 - sagitta) * axis);
}

float LitRegionsFrom::density(const Vec3& direction) const {
    const float sum = spheres_.density(direction);
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
