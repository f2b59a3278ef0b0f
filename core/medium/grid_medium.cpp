#include "core/medium/grid_medium.h"

namespace etalon {
namespace {

constexpr float lerp(float t, float a, float b) {
    return a + t * (b - a);
}

float largest_of(const Color& c) {
    return std::max({c.x, c.y, c.z});
}

/// What of the throughput's channels on average has a property that each has by that part.
double average(const Color& throughput, const Color& parts) {
    const double sum = static_cast<double>(throughput.x) + throughput.y + throughput.z;
    return sum > 0 ? throughput.dot(parts) / sum : (parts.x + parts.y + parts.z) / 3;
}

/// Ends most estimates that have become small. Returns whether this one goes on.
bool survives(Color& estimate, RandomSequence& numbers) {
    constexpr float small = 0.1F;
    const float most = largest_of(estimate);
    if (most >= small) return true;
    const float survival = most / small;
    if (!(numbers.next() < survival)) return false;
    estimate /= survival;
    return true;
}

}  // namespace

GridMedium::GridMedium(const PhysicalMedium& medium)
    : medium_(medium),
      grid_(*medium.grid),
      bounds_(grid_),
      extinction_(medium.extinction()),
      largest_(largest_of(extinction_)),
      relative_(largest_ > 0 ? extinction_ / largest_ : Color(0.0F)) {}

RaySegment GridMedium::in_box(const RaySegment& segment) const {
    return {grid_.to_box.point(segment.origin), grid_.to_box.vector(segment.direction),
            segment.length};
}

float GridMedium::density(const Vec3& point) const {
    const std::ptrdiff_t nx = grid_.size[0], ny = grid_.size[1], nz = grid_.size[2];
    const double x = point.x * grid_.size[0] - 0.5, y = point.y * grid_.size[1] - 0.5,
                 z = point.z * grid_.size[2] - 0.5;
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const auto ix = static_cast<std::ptrdiff_t>(fx), iy = static_cast<std::ptrdiff_t>(fy),
               iz = static_cast<std::ptrdiff_t>(fz);
    const auto dx = static_cast<float>(x - fx), dy = static_cast<float>(y - fy),
               dz = static_cast<float>(z - fz);
    const std::ptrdiff_t layer = nx * ny;
    const bool is_inner =
        ix >= 0 && iy >= 0 && iz >= 0 && ix + 1 < nx && iy + 1 < ny && iz + 1 < nz;
    const auto cell = [&](int i, int j, int k) {
        if (!is_inner) {
            const bool is_outside = ix + i < 0 || iy + j < 0 || iz + k < 0 || ix + i >= nx ||
                                    iy + j >= ny || iz + k >= nz;
            if (is_outside) return 0.0F;
        }
        return grid_.densities[static_cast<std::size_t>((iz + k) * layer + (iy + j) * nx + ix + i)];
    };
    const auto line = [&](int j, int k) { return lerp(dx, cell(0, j, k), cell(1, j, k)); };
    const auto plane = [&](int k) { return lerp(dy, line(0, k), line(1, k)); };
    return lerp(dz, plane(0), plane(1));
}

FreeFlight GridMedium::sample(const RaySegment& segment, const Color& throughput, double first,
                              RandomSequence& numbers) const {
    const RaySegment in_grid = in_box(segment);
    DensityBounds::Walk walk(bounds_, in_grid);
    Color weight(1.0F);
    double at = walk.begin(), left = optical_distance(first);
    while (const auto step = walk.next()) {
        const double majorant = static_cast<double>(step->most) * largest_;
        for (;;) {
            const double rest = majorant * (step->end - at);
            if (!(left < rest)) {
                left -= rest;
                at = step->end;
                break;
            }
            at += left / majorant;
            left = optical_distance(numbers.next());
            const float part = density(in_grid.point(at)) / step->most;
            const Color real = std::min(part, 1.0F) * relative_;
            const double probability = average(throughput * weight, real);
            if (numbers.next() < probability) {
                const Color scattered = (part / largest_) * medium_.scattering;
                return {at, weight * scattered / static_cast<float>(probability)};
            }
            weight *= (Color(1.0F) - real) / static_cast<float>(1 - probability);
        }
    }
    return {infinity, weight};
}

Color GridMedium::transmittance(const RaySegment& segment, RandomSequence& numbers) const {
    const RaySegment in_grid = in_box(segment);
    DensityBounds::Walk walk(bounds_, in_grid);
    Color estimate(1.0F);
    double at = walk.begin(), known = 0;  // known: the integral of the least densities
    double left = optical_distance(numbers.next());
    while (const auto step = walk.next()) {
        const float range = step->most - step->least;
        const double majorant = static_cast<double>(range) * largest_;
        known += step->least * (step->end - at);
        while (left < majorant * (step->end - at)) {
            at += left / majorant;
            left = optical_distance(numbers.next());
            const float part = (density(in_grid.point(at)) - step->least) / range;
            estimate *= Color(1.0F) - std::clamp(part, 0.0F, 1.0F) * relative_;
            if (!survives(estimate, numbers)) return Color(0.0F);
        }
        left -= majorant * (step->end - at);
        at = step->end;
    }
    return estimate * etalon::transmittance(extinction_, known);
}

}  // namespace etalon
