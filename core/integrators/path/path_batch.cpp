#include "core/integrators/path/path_batch.h"

#include <algorithm>

#include "core/integrators/path/ray_segments.h"
#include "core/sampling/dimensions.h"

namespace etalon {

template <bool in_media>
PathBatch<in_media>::PathBatch(const PathScene& scene, const CameraSamples& samples,
                               std::span<Color> colors, RayCounts& counts, PathLight light)
    : shared_(scene),
      colors_(colors),
      counts_(counts),
      points_(scene),
      below_(scene),
      flights_(scene) {
    const std::size_t count = samples.rays.size();
    wave_.rays.reserve(count);
    wave_.paths.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        wave_.rays.push_back(samples.rays[i]);
        wave_.paths.push_back({i, camera_ray_name, samples.sources[i]});
        wave_.paths.back().last_ray = light == PathLight::emission;
    }
    if constexpr (in_media) wave_.media.assign(count, scene.scene.physical().camera_medium);
    counts_.camera += count;
}

template <bool in_media>
void PathBatch<in_media>::run() {
    std::ranges::fill(colors_, Color(0.0F));
    for (bool from_camera = true; !wave_.paths.empty(); from_camera = false) {
        wave_.hits.resize(wave_.rays.size());
        shared_.intersector.closest(wave_.rays, wave_.hits);
        shadows_.clear();
        if constexpr (in_media) flights_.sample(wave_, shadows_);
        make_points();
        next_.clear();
        shade_all(from_camera);
        if (!below_.empty()) leave_surfaces();
        shadows_.trace(shared_, colors_, counts_);
        std::swap(wave_, next_);
    }
}

/// Generates the random numbers of all vertices.
template <bool in_media>
void PathBatch<in_media>::make_points() {
    points_.clear();
    for (std::size_t i = 0; i < wave_.rays.size(); ++i) {
        if (may_scatter(i)) points_.add(wave_.paths[i]);
    }
    points_.make();
}

template <bool in_media>
void PathBatch<in_media>::shade_all(bool from_camera) {
    VertexNumbers numbers;
    for (std::size_t i = 0; i < wave_.rays.size(); ++i) {
        if (is_in_medium(i)) {
            scatter_in_medium(i, numbers);
        } else if (wave_.hits[i].primitive == no_index) {
            add_escaped(wave_.paths[i], wave_.rays[i].direction);
        } else {
            ++(from_camera ? counts_.camera_hits : counts_.secondary_hits);
            shade(i, numbers);
        }
        if (!may_scatter(i)) continue;
        ++numbers.vertex;
        numbers.first_split += shared_.split_count(wave_.paths[i]);
    }
}

template <bool in_media>
void PathBatch<in_media>::shade(std::size_t ray, const VertexNumbers& numbers) {
    PathState& path = wave_.paths[ray];
    const Vec3& direction = wave_.rays[ray].direction;
    const PhysicalSurface surface =
        physical_surface(shared_.scene, wave_.rays[ray], wave_.hits[ray]);
    add_emitted(path, surface, direction);
    if (has_null_material(shared_.scene, surface)) {
        if (may_pass(path)) pass(ray, surface);
        return;
    }
    if (!may_scatter(ray)) return;
    LazyStorage<LobeList> room;
    LazyStorage<Subsurface> room_below;
    const auto [frame, lobes] = shared_.shading.scattering(surface, room);
    SurfaceVertex at{
        {numbers, lobes.has_smooth() ? shared_.split_count(path) : 1},
        surface,
        frame,
        BsdfFrom(frame, lobes, -normalized(direction)),
        in_media ? wave_.media[ray] : no_index,
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

/// Continues a path beyond a surface without a material.
template <bool in_media>
void PathBatch<in_media>::pass(std::size_t ray, const PhysicalSurface& surface) {
    next_.rays.push_back(ray_beyond(wave_.rays[ray], wave_.hits[ray], surface.point.convexity));
    PathState& path = next_.paths.emplace_back(wave_.paths[ray]);
    if constexpr (in_media) {
        path.name = ray_name(path.name, true);
        next_.media.push_back(medium_beyond(surface, wave_.rays[ray].direction, wave_.media[ray]));
    } else {
        path.is_unlit = !path.specular;
    }
    ++counts_.refracted;
}

/// Scatters a path in the medium that its ray passes.
template <bool in_media>
void PathBatch<in_media>::scatter_in_medium(std::size_t ray, const VertexNumbers& numbers) {
    PathState& path = wave_.paths[ray];
    const Vec3 direction = normalized(wave_.rays[ray].direction);
    path.last.position =
        wave_.rays[ray].origin + flights_.distance(ray) * wave_.rays[ray].direction;
    path.last.normal = Vec3(0);
    MediumVertex at{{numbers, shared_.split_count(path)},
                    path.last.position,
                    direction,
                    shared_.media.phase(wave_.media[ray]),
                    wave_.media[ray],
                    wave_.rays[ray].time(),
                    segment_of(wave_.rays[ray], end_of(wave_.hits[ray])),
                    flights_.density(ray)};
    at.survival = survival(path);  // the direction does not change the throughput
    see_lit_regions(path.last, at);
    if (!shared_.lights.empty()) sample_lights(path, at);
    scatter(path, at);
}

/// Continues all paths that went below surfaces from where they leave.
template <bool in_media>
void PathBatch<in_media>::leave_surfaces() {
    const auto exits = below_.find_exits(counts_);
    points_.clear();
    for (const SubsurfaceQueue::Exit& exit : exits) points_.add(exit.path);
    points_.make();
    VertexNumbers numbers;
    for (const SubsurfaceQueue::Exit& exit : exits) {
        leave(exit, numbers);
        ++numbers.vertex;
        numbers.first_split += shared_.split_count(exit.path);
    }
    below_.clear();
}

/// Samples lights at such a point, and continues from there.
template <bool in_media>
void PathBatch<in_media>::leave(const SubsurfaceQueue::Exit& exit, const VertexNumbers& numbers) {
    const BsdfFrame frame(exit.surface.ng, exit.surface.ns);
    LobeList lobes;
    lobes.add(DiffuseExit(exit.eta));
    const SurfaceVertex at{{numbers, shared_.split_count(exit.path)},
                           exit.surface,
                           frame,
                           BsdfFrom(frame, lobes, exit.surface.ns),
                           exit.medium};
    if (!shared_.lights.empty()) sample_lights(exit.path, at);
    scatter(exit.path, at);
}

template class PathBatch<false>;
template class PathBatch<true>;

}  // namespace etalon
