#include "core/integrators/path/subsurface_queue.h"

#include <algorithm>

#include "core/diffusion/profile_sampling.h"
#include "core/sampling/dimensions.h"

namespace etalon {

void SubsurfaceQueue::clear() {
    entries_.clear();
    textured_.clear();
}

void SubsurfaceQueue::add(const PathState& path, const SurfaceVertex& at,
                          const BsdfSample& sample) {
    const SurfacePoint& point = at.surface.point;
    const Subsurface* below = at.subsurface;
    if (!scene_.shading.has_constant_subsurface(at.surface))
        below = &textured_.emplace_back(*below);
    entries_.push_back({path, point.position, at.frame, below,
                        scene_.shading.material_below(at.surface), at.medium, point.time});
    entries_.back().path.throughput *= sample.f * (at.cosine(sample.wi) / sample.pdf);
}

std::span<const SubsurfaceQueue::Exit> SubsurfaceQueue::find_exits(RayCounts& counts) {
    send_probes();
    trace_probes(counts);
    choose_exits();
    return exits_;
}

void SubsurfaceQueue::send_probes() {
    probe_points_.clear();
    for (const Entry& e : entries_) e.path.source.add_vertex(e.path.name, probe_points_);
    probe_points_.make(scene_.sampler);
    probes_.clear();
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
        const Entry& e = entries_[i];
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
void SubsurfaceQueue::trace_probes(RayCounts& counts) {
    probe_hits_.clear();
    while (!probes_.empty()) {
        probe_rays_.clear();
        for (const ProbeHit& probe : probes_) probe_rays_.push_back(probe.ray);
        found_.resize(probes_.size());
        scene_.intersector.closest(probe_rays_, found_);
        counts.refracted += probes_.size();
        std::size_t count = 0;
        for (std::size_t i = 0; i < probes_.size(); ++i) {
            if (found_[i].primitive == no_index) continue;
            ++counts.secondary_hits;
            ProbeHit probe = probes_[i];
            probe.hit = found_[i];
            const PhysicalSurface at = physical_surface(scene_.scene, probe.ray, probe.hit);
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
void SubsurfaceQueue::choose_exits() {
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
void SubsurfaceQueue::take_exit(const ProbeHit& met, std::uint32_t count) {
    Entry& e = entries_[met.entry];
    const PhysicalSurface at = physical_surface(scene_.scene, met.ray, met.hit);
    const ProfileSampling sampling(e.subsurface->profile, e.frame, e.position);
    const float density = sampling.density(at.point.position, at.ng);
    if (!(density > 0)) return;
    PathState& path = e.path;
    path.throughput *= sampling.value(at.point.position) * (static_cast<float>(count) / density);
    if (path.throughput == Color(0.0F)) return;
    path.name = exit_name(path.name);
    path.last.position = at.point.position;
    path.last.normal = at.ng;
    exits_.push_back({path, at, e.subsurface->eta, e.medium});
}

}  // namespace etalon
