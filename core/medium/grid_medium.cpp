#include "core/medium/grid_medium.h"

#include "core/medium/channels.h"
#include "core/medium/grid_cell.h"

namespace etalon {
namespace {

/// Optical thickness beyond which transmitted light is no more than a rounding of the scattered
/// light.
constexpr float all_but_a_rounding = 17;

/// Number of collisions after which the rest of a segment is integrated instead. Where one channel
/// is far denser than another, nearly all collisions are null for the light that is left.
constexpr int most_collisions = 256;

RaySegment rest_of(const RaySegment& segment, double at) {
    return {segment.point(at), segment.direction, segment.length - at};
}

float largest_of(const Color& c) {
    return std::max({c.x, c.y, c.z});
}

/// Returns the average of a property over the throughput's channels, weighted by each channel's
/// part.
double average(const Color& throughput, const Color& parts) {
    const double sum = static_cast<double>(throughput.x) + throughput.y + throughput.z;
    return sum > 0 ? throughput.dot(parts) / sum : (parts.x + parts.y + parts.z) / 3;
}

/// Ends most estimates that have become small, by Russian roulette. Returns whether this one goes
/// on.
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
      relative_(largest_ > 0 ? extinction_ / largest_ : Color(0.0F)) {
    for (int c = 0; c < 3; ++c) {
        albedo_[c] = extinction_[c] > 0 ? medium.scattering[c] / extinction_[c] : 0;
    }
}

RaySegment GridMedium::in_box(const RaySegment& segment) const {
    return {grid_.to_box.point(segment.origin), grid_.to_box.vector(segment.direction),
            segment.length};
}

FreeFlight GridMedium::sample(const RaySegment& segment, const Color& throughput, double first,
                              RandomSequence& numbers) const {
    const RaySegment in_grid = in_box(segment);
    DensityBounds::Traversal traversal(bounds_, in_grid);
    Color weight(1.0F);
    int collisions = 0;
    double at = traversal.begin(), left = optical_distance(first);
    while (const auto step = traversal.next()) {
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
            const float part = density_at(grid_, in_grid.point(at)) / step->most;
            const Color real = std::min(part, 1.0F) * relative_;
            const double probability = average(throughput * weight, real);
            if (numbers.next() < probability) {
                const Color scattered = (part / largest_) * medium_.scattering;
                return {at, weight * scattered / static_cast<float>(probability)};
            }
            weight *= (Color(1.0F) - real) / static_cast<float>(1 - probability);
            if (++collisions < most_collisions) continue;
            FreeFlight flight = sample_rest(rest_of(segment, at), throughput * weight, numbers);
            return {at + flight.distance, weight * flight.weight};
        }
    }
    return {infinity, weight};
}

/// Samples how far a ray goes by integrating the density.
FreeFlight GridMedium::sample_rest(const RaySegment& segment, const Color& throughput,
                                   RandomSequence& numbers) const {
    DensityProfile profile;
    const DividedLight light = divide(segment, profile);
    const double probability = average(throughput, removed(profile));
    if (!(numbers.next() < probability)) {
        return {infinity, light.passing / static_cast<float>(1 - probability)};
    }
    const double distance = numbers.next();
    FreeFlight flight = sample(profile, throughput, {distance, numbers.next()});
    flight.weight /= static_cast<float>(probability);
    return flight;
}

DividedLight GridMedium::divide(const RaySegment& segment, DensityProfile& profile) const {
    const float least = std::min({extinction_.x, extinction_.y, extinction_.z});
    profile.make(grid_, bounds_, in_box(segment), all_but_a_rounding / least);
    if (least * profile.total() >= all_but_a_rounding) return {Color(0.0F), albedo_};
    return {etalon::transmittance(extinction_, profile.total()), removed(profile) * albedo_};
}

/// Returns the fraction of the light that does not pass.
Color GridMedium::removed(const DensityProfile& profile) const {
    Color result;
    for (int c = 0; c < 3; ++c) {
        result[c] = static_cast<float>(-std::expm1(-extinction_[c] * profile.total()));
    }
    return result;
}

FreeFlight GridMedium::sample(const DensityProfile& profile, const Color& throughput,
                              const Vec2& choices) const {
    const Color parts = removed(profile), weights = throughput * parts;
    const float sum = weights.x + weights.y + weights.z;
    const FreeFlight nowhere{infinity, Color(0.0F)};
    if (!(sum > 0 && std::isfinite(sum))) return nowhere;
    const int c = chosen_channel(weights / sum, choices.y);
    const double wanted = -std::log1p(-choices.x * parts[c]) / extinction_[c];
    if (!(wanted < profile.total())) return nowhere;
    const DensityProfile::Point at = profile.find(wanted);
    const float density =
        throughput.dot(extinction_ * etalon::transmittance(extinction_, wanted)) / sum;
    const Color value = medium_.scattering * etalon::transmittance(extinction_, at.integral);
    return {at.distance, value * static_cast<float>(at.density_factor / density)};
}

Color GridMedium::transmittance(const RaySegment& segment, RandomSequence& numbers) const {
    const RaySegment in_grid = in_box(segment);
    DensityBounds::Traversal traversal(bounds_, in_grid);
    Color estimate(1.0F);
    int collisions = 0;
    double at = traversal.begin(), known = 0;  // known: the integral of the least densities
    double left = optical_distance(numbers.next());
    while (const auto step = traversal.next()) {
        const float range = step->most - step->least;
        const double majorant = static_cast<double>(range) * largest_;
        known += step->least * (step->end - at);
        while (left < majorant * (step->end - at)) {
            at += left / majorant;
            left = optical_distance(numbers.next());
            const float part = (density_at(grid_, in_grid.point(at)) - step->least) / range;
            estimate *= Color(1.0F) - std::clamp(part, 0.0F, 1.0F) * relative_;
            if (!survives(estimate, numbers)) return Color(0.0F);
            if (++collisions < most_collisions) continue;
            known -= step->least * (step->end - at);
            DensityProfile rest;
            return estimate * etalon::transmittance(extinction_, known) *
                   divide(rest_of(segment, at), rest).passing;
        }
        left -= majorant * (step->end - at);
        at = step->end;
    }
    return estimate * etalon::transmittance(extinction_, known);
}

}  // namespace etalon
