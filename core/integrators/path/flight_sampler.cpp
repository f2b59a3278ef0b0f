#include "core/integrators/path/flight_sampler.h"

#include <algorithm>

#include "core/integrators/path/light_along_rays.h"
#include "core/integrators/path/ray_segments.h"
#include "core/sampling/dimensions.h"

namespace etalon {
namespace {

/// Returns at how many points of a grid medium a path is scattered where it first enters one.
/// Chosen by measurement, like the number of split paths: few paths continue from dark ones.
std::uint32_t places_in(const GridMedium& grid) {
    constexpr float dark = 0.4F;  // albedo below which not all paths continue from the first point
    constexpr std::uint32_t places = 2, dark_places = 4;
    const Color& albedo = grid.albedo();
    return std::max({albedo.x, albedo.y, albedo.z}) < dark ? dark_places : places;
}

/// Returns the parameter of a ray at a distance from where its segment begins.
double parameter_at(const Ray& ray, double distance) {
    return std::max(ray.tmin, 0.0) + distance / ray.direction.length();
}

}  // namespace

void FlightSampler::sample(PathWave& wave, ShadowQueue& shadows) {
    const std::size_t count = wave.rays.size();  // without those that divide() adds
    distances_.assign(count, infinity);
    densities_.assign(count, 0);
    make_points(wave);
    std::size_t number = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (wave.media[i] == no_index) continue;
        if (!flies(wave, i)) {
            PathState& path = wave.paths[i];
            RandomSequence numbers = path.source.sequence(collision_dimension(path.name));
            path.throughput *= scene_.media.transmittance(
                wave.media[i], segment_of(wave.rays[i], end_of(wave.hits[i])), numbers);
        } else if (const GridMedium* grid = grid_to_divide(wave, i)) {
            divide(wave, i, *grid, number);
            number += places_in(*grid);
        } else {
            sample(wave, i, number++, shadows);
        }
    }
}

void FlightSampler::make_points(const PathWave& wave) {
    points_.clear();
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
        if (!flies(wave, i)) continue;
        const GridMedium* grid = grid_to_divide(wave, i);
        const std::uint32_t parts = grid ? places_in(*grid) : 1;
        for (std::uint32_t k = 0; k < parts; ++k)
            wave.paths[i].source.part(k, parts).add_vertex(wave.paths[i].name, points_);
    }
    points_.make(scene_.sampler);
}

/// Samples how far a ray goes in its medium, with the points of that number.
void FlightSampler::sample(PathWave& wave, std::size_t ray, std::size_t number,
                           ShadowQueue& shadows) {
    PathState& path = wave.paths[ray];
    const std::uint32_t medium = wave.media[ray];
    const RaySegment segment = segment_of(wave.rays[ray], end_of(wave.hits[ray]));
    const bool asks = scene_.lights.has_point_lights() && scene_.media.knows_densities(medium);
    if (asks) {
        sample_light_along(scene_, path, {segment, medium, wave.rays[ray].time()},
                           points_.choices(number), shadows);
    }
    const FreeFlight flight = scene_.media.sample(
        medium, segment, path.throughput,
        {points_.place(number), path.source.sequence(collision_dimension(path.name))});
    path.throughput *= flight.weight;
    if (path.throughput == Color(0.0F)) {
        wave.hits[ray].primitive = no_index;  // the rest of the path contributes nothing
    } else if (flight.scatters()) {
        distances_[ray] = parameter_at(wave.rays[ray], flight.distance);
        if (asks) densities_[ray] = flight.density;
    }
}

/// Splits a path into the part that passes a grid and the part that is scattered at some points of
/// it, instead of choosing one of these. Russian roulette may end the part that carries little; a
/// path that only passes is not split. The parts come after all other rays.
void FlightSampler::divide(PathWave& wave, std::size_t ray, const GridMedium& grid,
                           std::size_t number) {
    constexpr float surely_kept = 8;  // times the share of the light
    PathState path = wave.paths[ray];
    const auto [passing, scattered] =
        grid.divide(segment_of(wave.rays[ray], end_of(wave.hits[ray])), profile_);
    const float passes = path.throughput.dot(passing), scatters = path.throughput.dot(scattered);
    const double choice = path.source.sequence(collision_dimension(path.name)).next();
    const auto weight = [&](float part) {
        const float survival = std::min(surely_kept * part / (passes + scatters), 1.0F);
        return choice < survival ? 1 / survival : 0;
    };
    wave.paths[ray].throughput *= passing * weight(passes);
    if (weight(scatters) == 0) return;
    path.is_split = true;
    const std::uint32_t places = places_in(grid);
    path.throughput *= weight(scatters) / static_cast<float>(places);
    path.roulette_scale *= static_cast<float>(places);
    for (std::uint32_t place = 0; place < places; ++place) {
        PathState part = path;
        part.source = path.source.part(place, places);
        add_scattered(wave, ray, part,
                      grid.sample(profile_, part.throughput, points_.place(number + place)));
    }
    wave.paths[ray].is_split = true;
    wave.paths[ray].name = passing_name(path.name);
    if (weight(passes) == 0) wave.hits[ray].primitive = no_index;  // the rest contributes nothing
}

/// Adds a part of a ray's path that is scattered after a flight.
void FlightSampler::add_scattered(PathWave& wave, std::size_t ray, const PathState& path,
                                  const FreeFlight& flight) {
    if (flight.weight == Color(0.0F)) return;
    wave.paths.push_back(path);
    wave.paths.back().throughput *= flight.weight;
    wave.rays.push_back(Ray(wave.rays[ray]));
    wave.hits.push_back(Hit(wave.hits[ray]));
    wave.media.push_back(std::uint32_t(wave.media[ray]));
    distances_.push_back(parameter_at(wave.rays[ray], flight.distance));
    densities_.push_back(0);
}

}  // namespace etalon
