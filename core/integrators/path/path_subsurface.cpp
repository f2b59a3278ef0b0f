// Paths that enter a surface below which light is scattered: they continue from other points of
// surfaces of the same material, found by probe rays, as in pbrt-v3.
#include <algorithm>

#include "core/diffusion/profile_sampling.h"
#include "core/integrators/path/path_batch.h"
#include "core/sampling/dimensions.h"

namespace etalon {

/// Records a path that passes the surface of a vertex.
template <bool in_media>
void PathBatch<in_media>::enter(const Path& path, const SurfaceVertex& at,
                                const BsdfSample& sample) {
    const SurfacePoint& point = at.surface.point;
    const Subsurface* below = at.subsurface;
    if (!shared_.shading.has_constant_subsurface(at.surface))
        below = &textured_.emplace_back(*below);
    entries_.push_back({path, point.position, at.frame, below,
                        shared_.shading.material_below(at.surface), at.medium, point.time});
    entries_.back().path.throughput *= sample.f * (at.cosine(sample.wi) / sample.pdf);
}

/// Continues all paths that went below surfaces.
template <bool in_media>
void PathBatch<in_media>::scatter_below() {
    send_probes();
    trace_probes();
    choose_exits();
    clear_points();
    for (const SubsurfaceExit& exit : exits_) add_points(entries_[exit.entry].path);
    make_added_points();
    VertexNumbers numbers;
    for (const SubsurfaceExit& exit : exits_) {
        leave(exit, numbers);
        ++numbers.vertex;
        numbers.first_split += split_count(entries_[exit.entry].path);
    }
    entries_.clear();
    textured_.clear();
}

template <bool in_media>
void PathBatch<in_media>::send_probes() {
    probe_points_.clear();
    for (const SubsurfaceEntry& e : entries_) e.path.source.add_vertex(e.path.name, probe_points_);
    probe_points_.make(shared_.sampler);
    probes_.clear();
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
        const SubsurfaceEntry& e = entries_[i];
        const ProfileSampling sampling(e.subsurface->profile, e.frame, e.position);
        const auto probe = sampling.probe(probe_points_.choices(i).x, probe_points_.place(i));
        if (!probe) continue;
        Ray ray{probe->origin, probe->direction};
        ray.tmax = probe->length;
        ray.set_time(e.time);
        probes_.push_back({i, ray, {}});
    }
}

/// Finds all surfaces of the entries' materials that the probes hit.
template <bool in_media>
void PathBatch<in_media>::trace_probes() {
    probe_hits_.clear();
    while (!probes_.empty()) {
        probe_rays_.clear();
        for (const ProbeHit& probe : probes_) probe_rays_.push_back(probe.ray);
        found_.resize(probes_.size());
        shared_.intersector.closest(probe_rays_, found_);
        counts_.refracted += probes_.size();
        std::size_t count = 0;
        for (std::size_t i = 0; i < probes_.size(); ++i) {
            if (found_[i].primitive == no_index) continue;
            ++counts_.secondary_hits;
            ProbeHit probe = probes_[i];
            probe.hit = found_[i];
            const PhysicalSurface at = physical_surface(shared_.scene, probe.ray, probe.hit);
            if (at.binding->material == entries_[probe.entry].material) {
                probe_hits_.push_back(probe);
            }
            probe.ray = ray_beyond(probe.ray, probe.hit, at.point.convexity);
            if (probe.ray.tmin < probe.ray.tmax) probes_[count++] = probe;
        }
        probes_.resize(count);
    }
}

/// Chooses one of the surfaces that each probe hit.
template <bool in_media>
void PathBatch<in_media>::choose_exits() {
    exits_.clear();
    std::ranges::stable_sort(probe_hits_, {}, &ProbeHit::entry);
    for (std::size_t begin = 0, end = 0; begin < probe_hits_.size(); begin = end) {
        const std::uint32_t entry = probe_hits_[begin].entry;
        while (end < probe_hits_.size() && probe_hits_[end].entry == entry) ++end;
        const std::size_t count = end - begin;
        const double choice = probe_points_.choices(entry).y;
        const auto chosen = static_cast<std::size_t>(choice * static_cast<double>(count));
        take_exit(probe_hits_[begin + chosen], static_cast<std::uint32_t>(count));
    }
}

/// Lets a path leave where its probe hit one of `count` surfaces, if any light comes from there.
template <bool in_media>
void PathBatch<in_media>::take_exit(const ProbeHit& met, std::uint32_t count) {
    SubsurfaceEntry& e = entries_[met.entry];
    const PhysicalSurface at = physical_surface(shared_.scene, met.ray, met.hit);
    const ProfileSampling sampling(e.subsurface->profile, e.frame, e.position);
    const float density = sampling.density(at.point.position, at.ng);
    if (!(density > 0)) return;
    Path& path = e.path;
    path.throughput *= sampling.value(at.point.position) * (static_cast<float>(count) / density);
    if (path.throughput == Color(0.0F)) return;
    path.name = exit_name(path.name);
    path.last.position = at.point.position;
    path.last.normal = at.ng;
    exits_.push_back({met.entry, at});
}

/// Samples lights at such a point, and continues from there.
template <bool in_media>
void PathBatch<in_media>::leave(const SubsurfaceExit& exit, const VertexNumbers& numbers) {
    SubsurfaceEntry& e = entries_[exit.entry];
    const PhysicalSurface& surface = exit.surface;
    const BsdfFrame frame(surface.ng, surface.ns);
    LobeList lobes;
    lobes.add(DiffuseExit(e.subsurface->eta));
    const SurfaceVertex at{{numbers, split_count(e.path)},
                           surface,
                           frame,
                           BsdfFrom(frame, lobes, surface.ns),
                           e.medium};
    if (!shared_.lights.empty()) sample_lights(e.path, at);
    scatter(e.path, at);
}

template void PathBatch<false>::enter(const Path&, const SurfaceVertex&, const BsdfSample&);
template void PathBatch<true>::enter(const Path&, const SurfaceVertex&, const BsdfSample&);
template void PathBatch<false>::scatter_below();
template void PathBatch<true>::scatter_below();

}  // namespace etalon
