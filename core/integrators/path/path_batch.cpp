#include "core/integrators/path/path_batch.h"

#include <algorithm>

#include "core/integrators/path/ray_segments.h"
#include "core/sampling/dimensions.h"

namespace etalon {

template <bool in_media>
PathBatch<in_media>::PathBatch(const PathScene& scene, const CameraSamples& samples,
                               std::span<Color> colors, RayCounts& counts, int most_vertices)
    : shared_(scene),
      samples_(samples),
      colors_(colors),
      counts_(counts),
      most_vertices_(most_vertices) {
    rays_.reserve(samples.rays.size());
    for (std::size_t i = 0; i < samples.rays.size(); ++i) rays_.push_back(samples.rays[i]);
    paths_.reserve(rays_.size());
    for (std::uint32_t i = 0; i < rays_.size(); ++i) {
        paths_.push_back({i, camera_ray_name, samples.sources[i]});
    }
    if constexpr (in_media) media_.assign(rays_.size(), scene.scene.physical().camera_medium);
    counts_.camera += rays_.size();
}

template <bool in_media>
void PathBatch<in_media>::run() {
    std::ranges::fill(colors_, Color(0.0F));
    for (bool from_camera = true; !paths_.empty(); from_camera = false) {
        hits_.resize(rays_.size());
        shared_.intersector.closest(rays_, hits_);
        shadow_rays_.clear();
        light_contributions_.clear();
        if constexpr (in_media) {
            shadow_media_.clear();
            sample_flights();
        }
        make_points();
        shade_all(from_camera);
        if (!entries_.empty()) scatter_below();
        add_light_contributions();
        std::swap(rays_, next_rays_);
        std::swap(paths_, next_paths_);
        if constexpr (in_media) std::swap(media_, next_media_);
    }
}

template <bool in_media>
void PathBatch<in_media>::make_points() {
    clear_points();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (may_scatter(i)) add_points(paths_[i]);
    }
    make_added_points();
}

template <bool in_media>
void PathBatch<in_media>::clear_points() {
    light_choices_.clear();
    direction_choices_.clear();
    light_points_.clear();
}

/// Adds the choices of a path's next vertex to those that are generated together.
template <bool in_media>
void PathBatch<in_media>::add_points(const Path& path) {
    const std::uint32_t count = split_count(path);
    for (std::uint32_t i = 0; i < count; ++i) {
        path.source.part(i, count).add_vertex(path.name, direction_choices_);
    }
    if (shared_.samples_all) {
        add_light_points(path);
    } else {
        path.source.add_vertex(path.name, light_choices_);
    }
}

template <bool in_media>
void PathBatch<in_media>::make_added_points() {
    light_choices_.make(shared_.sampler);
    direction_choices_.make(shared_.sampler);
    on_lights_ = light_points_.make(shared_.sampler);
}

template <bool in_media>
void PathBatch<in_media>::add_light_points(const Path& path) {
    for (std::uint32_t light = 0; light < shared_.lights.size(); ++light) {
        const auto samples = static_cast<std::uint32_t>(shared_.lights.samples(light));
        const std::uint32_t dimension = light_dimension(path.name, light);
        for (std::uint32_t k = 0; k < samples; ++k) {
            path.source.add_stratified(dimension, k, samples, light_points_);
        }
    }
}

template <bool in_media>
void PathBatch<in_media>::shade_all(bool from_camera) {
    next_rays_.clear();
    next_paths_.clear();
    if constexpr (in_media) next_media_.clear();
    VertexNumbers numbers;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (is_in_medium(i)) {
            scatter_in_medium(i, numbers);
        } else if (hits_[i].primitive == no_index) {
            add_escaped(paths_[i], rays_[i].direction);
        } else {
            ++(from_camera ? counts_.camera_hits : counts_.secondary_hits);
            shade(i, numbers);
        }
        if (!may_scatter(i)) continue;
        ++numbers.vertex;
        numbers.first_split += split_count(paths_[i]);
    }
}

template <bool in_media>
void PathBatch<in_media>::shade(std::size_t ray, const VertexNumbers& numbers) {
    Path& path = paths_[ray];
    const Vec3& direction = rays_[ray].direction;
    const PhysicalSurface surface = physical_surface(shared_.scene, rays_[ray], hits_[ray]);
    add_emitted(path, surface, direction);
    if (shared_.shading.has_null_material(surface)) {
        next_rays_.push_back(ray_beyond(rays_[ray], hits_[ray], surface.point.convexity));
        next_paths_.push_back(path);
        if constexpr (in_media) {
            next_paths_.back().name = ray_name(path.name, true);
            next_media_.push_back(medium_beyond(surface, direction, media_[ray]));
        } else {
            next_paths_.back().is_unlit = !path.specular;
        }
        ++counts_.refracted;
        return;
    }
    if (!may_scatter(ray)) return;
    LazyStorage<LobeList> room;
    LazyStorage<Subsurface> room_below;
    const auto [frame, lobes] = shared_.shading.scattering(surface, room);
    SurfaceVertex at{
        {numbers, lobes.has_smooth() ? split_count(path) : 1},
        surface,
        frame,
        BsdfFrom(frame, lobes, -normalized(direction)),
        in_media ? media_[ray] : no_index,
        shared_.direct_only ? nullptr : shared_.shading.subsurface(surface, room_below)};
    const bool is_above = surface.ng.dot(direction) < 0;
    path.last.position = surface.point.position;
    path.last.normal = lobes.has_smooth_transmission() ? Vec3(0)
                       : is_above                      ? surface.ng
                                                       : -surface.ng;
    if (lobes.has_smooth() && !lobes.has_smooth_transmission()) see_lit_regions(path.last, at);
    if (lobes.has_smooth() && !shared_.lights.empty()) sample_lights(path, at);
    scatter(path, at);
}

/// Scatters a path in the medium that its ray passes.
template <bool in_media>
void PathBatch<in_media>::scatter_in_medium(std::size_t ray, const VertexNumbers& numbers) {
    Path& path = paths_[ray];
    const Vec3 direction = normalized(rays_[ray].direction);
    path.last.position = rays_[ray].origin + flights_[ray] * rays_[ray].direction;
    path.last.normal = Vec3(0);
    MediumVertex at{{numbers, split_count(path)},
                    path.last.position,
                    direction,
                    shared_.media.phase(media_[ray]),
                    media_[ray],
                    rays_[ray].time(),
                    segment_of(rays_[ray], end_of(hits_[ray])),
                    flight_densities_[ray]};
    at.survival = survival(path);  // the direction does not change the throughput
    see_lit_regions(path.last, at);
    if (!shared_.lights.empty()) sample_lights(path, at);
    scatter(path, at);
}

template class PathBatch<false>;
template class PathBatch<true>;

}  // namespace etalon
