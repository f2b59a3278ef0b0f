// Scattering of paths in media.
#include <numeric>

#include "core/integrators/path/path_batch.h"
#include "core/integrators/path/ray_segments.h"
#include "core/sampling/dimensions.h"

namespace etalon {

/// Samples how far all rays go in their media.
template <bool in_media>
void PathBatch<in_media>::sample_flights() {
    flights_.assign(rays_.size(), infinity);
    flight_densities_.assign(rays_.size(), 0);
    flight_points_.clear();
    const auto flies = [&](std::size_t i) { return media_[i] != no_index && may_go_on(paths_[i]); };
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (flies(i)) add_flight_points(i);
    }
    flight_points_.make(shared_.sampler);
    std::size_t number = 0;
    const std::size_t count = rays_.size();  // without those that divide() adds
    for (std::size_t i = 0; i < count; ++i) {
        if (media_[i] == no_index) continue;
        if (flies(i) && divides(i)) {
            divide(i, number);
            number += places_of(i);
        } else if (flies(i)) {
            sample_flight(i, number++);
        } else {
            RandomSequence numbers = paths_[i].source.sequence(collision_dimension(paths_[i].name));
            paths_[i].throughput *= shared_.media.transmittance(
                media_[i], segment_of(rays_[i], end_of(hits_[i])), numbers);
        }
    }
}

template <bool in_media>
void PathBatch<in_media>::add_flight_points(std::size_t ray) {
    const std::uint32_t parts = divides(ray) ? places_of(ray) : 1;
    for (std::uint32_t i = 0; i < parts; ++i)
        paths_[ray].source.part(i, parts).add_vertex(paths_[ray].name, flight_points_);
}

/// Samples how far a ray goes in its medium, with the points of that number.
template <bool in_media>
void PathBatch<in_media>::sample_flight(std::size_t ray, std::size_t number) {
    Path& path = paths_[ray];
    Hit& hit = hits_[ray];
    const std::uint32_t medium = media_[ray];
    const RaySegment segment = segment_of(rays_[ray], end_of(hit));
    const bool asks = shared_.lights.has_point_lights() && shared_.media.knows_densities(medium);
    if (asks) sample_along(ray, segment, flight_points_.choices(number));
    const FreeFlight flight = shared_.media.sample(
        medium, segment, path.throughput,
        {flight_points_.place(number), path.source.sequence(collision_dimension(path.name))});
    path.throughput *= flight.weight;
    if (path.throughput == Color(0.0F)) {
        hit.primitive = no_index;  // the rest of the path contributes nothing
    } else if (flight.scatters()) {
        flights_[ray] =
            std::max(rays_[ray].tmin, 0.0) + flight.distance / rays_[ray].direction.length();
        if (asks) flight_densities_[ray] = flight.density;
    }
}

template <bool in_media>
std::uint32_t PathBatch<in_media>::places_of(std::size_t ray) const {
    constexpr float dark = 0.4F;  // albedo below which not all paths continue from the first point
    const Color& albedo = shared_.media.grid(media_[ray])->albedo();
    return std::max({albedo.x, albedo.y, albedo.z}) < dark ? dark_places : split_places;
}

/// Splits a path into the part that passes a grid and the part that is scattered at some points of
/// it, instead of choosing one of these. Russian roulette may end the part that carries little; a
/// path that only passes is not split. The parts come after all other rays.
template <bool in_media>
void PathBatch<in_media>::divide(std::size_t ray, std::size_t number) {
    constexpr float surely_kept = 8;  // times the share of the light
    Path path = paths_[ray];
    const auto [passing, scattered] =
        shared_.media.grid(media_[ray])
            ->divide(segment_of(rays_[ray], end_of(hits_[ray])), profile_);
    const float passes = path.throughput.dot(passing), scatters = path.throughput.dot(scattered);
    const double choice = path.source.sequence(collision_dimension(path.name)).next();
    const auto weight = [&](float part) {
        const float survival = std::min(surely_kept * part / (passes + scatters), 1.0F);
        return choice < survival ? 1 / survival : 0;
    };
    paths_[ray].throughput *= passing * weight(passes);
    if (weight(scatters) == 0) return;
    path.is_split = true;
    const std::uint32_t places = places_of(ray);
    path.throughput *= weight(scatters) / static_cast<float>(places);
    path.roulette_scale *= static_cast<float>(places);
    for (std::uint32_t place = 0; place < places; ++place) {
        Path part = path;
        part.source = path.source.part(place, places);
        add_scattered(ray, part, flight_points_.place(number + place));
    }
    paths_[ray].is_split = true;
    paths_[ray].name = passing_name(path.name);
    if (weight(passes) == 0) hits_[ray].primitive = no_index;  // the rest contributes nothing
}

/// Adds a part of a ray's path that is scattered in the profile's medium.
template <bool in_media>
void PathBatch<in_media>::add_scattered(std::size_t ray, const Path& path, const Vec2& choices) {
    const FreeFlight flight =
        shared_.media.grid(media_[ray])->sample(profile_, path.throughput, choices);
    if (flight.weight == Color(0.0F)) return;
    paths_.push_back(path);
    paths_.back().throughput *= flight.weight;
    rays_.push_back(Ray(rays_[ray]));
    hits_.push_back(Hit(hits_[ray]));
    media_.push_back(std::uint32_t(media_[ray]));
    flights_.push_back(std::max(rays_[ray].tmin, 0.0) +
                       flight.distance / rays_[ray].direction.length());
    flight_densities_.push_back(0);
}

/// Attenuates the light of lights by what is in the way: surfaces block it, media let a part pass.
template <bool in_media>
void PathBatch<in_media>::attenuate_light_contributions() {
    if (!shared_.shading.has_null_materials()) {
        shared_.intersector.occluded(shadow_rays_, blocked_);
        for (std::size_t i = 0; i < light_contributions_.size(); ++i) {
            if (blocked_[i] == 0) attenuate(i, shadow_rays_[i], shadow_rays_[i].tmax);
        }
        return;
    }
    std::ranges::fill(blocked_, std::uint8_t{0});
    passing_.resize(shadow_rays_.size());
    std::iota(passing_.begin(), passing_.end(), 0U);
    passing_rays_ = shadow_rays_;
    while (!passing_.empty()) {
        passing_hits_.resize(passing_rays_.size());
        shared_.intersector.closest(passing_rays_, passing_hits_);
        std::size_t count = 0;
        for (std::size_t i = 0; i < passing_.size(); ++i) {
            if (!passes(passing_[i], passing_rays_[i], passing_hits_[i])) continue;
            passing_[count] = passing_[i];
            passing_rays_[count++] = passing_rays_[i];
        }
        passing_.resize(count);
        passing_rays_.resize(count);
        counts_.shadow += count;
    }
}

/// Attenuates a contribution by the medium that its ray passes up to `end`.
template <bool in_media>
void PathBatch<in_media>::attenuate(std::size_t contribution, const Ray& ray, double end) {
    auto& [medium, numbers] = shadow_media_[contribution];
    if (medium == no_index) return;
    light_contributions_[contribution].color *=
        shared_.media.transmittance(medium, segment_of(ray, end), numbers);
}

/// Returns whether a shadow ray continues beyond its hit, if there is one. `ray` becomes the rest
/// of it.
template <bool in_media>
bool PathBatch<in_media>::passes(std::size_t contribution, Ray& ray, const Hit& hit) {
    if (hit.primitive == no_index) {
        attenuate(contribution, ray, ray.tmax);
        return false;
    }
    const PhysicalSurface at = physical_surface(shared_.scene, ray, hit);
    if (!shared_.shading.has_null_material(at)) {
        blocked_[contribution] = 1;
        return false;
    }
    attenuate(contribution, ray, hit.t);
    if (light_contributions_[contribution].color == Color(0.0F)) return false;
    std::uint32_t& medium = shadow_media_[contribution].medium;
    medium = medium_beyond(at, ray.direction, medium);
    ray = ray_beyond(ray, hit, at.point.convexity);
    return ray.tmin < ray.tmax;
}

template void PathBatch<true>::sample_flights();
template void PathBatch<true>::attenuate_light_contributions();

}  // namespace etalon
