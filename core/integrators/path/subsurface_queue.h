#pragma once

#include <deque>

#include "core/integrators/path/path_scene.h"
#include "core/integrators/path/path_vertices.h"
#include "core/integrators/ray_counts.h"

namespace etalon {

/// Paths that enter surfaces below which light is scattered. They continue from other points of
/// surfaces of the same material, found by probe rays, as in pbrt-v3. The scene must outlive it.
class SubsurfaceQueue {
  public:
    /// Point where a path leaves a surface from below.
    struct Exit {
        PathState& path;
        PhysicalSurface surface;
        float eta;             ///< index of refraction of what is below
        std::uint32_t medium;  ///< medium through which the path came
    };

    explicit SubsurfaceQueue(const PathScene& scene) : scene_(scene) {}

    bool empty() const { return entries_.empty(); }
    void clear();

    /// Adds a path that passes the surface of a vertex in a sampled direction.
    void add(const PathState& path, const SurfaceVertex& at, const BsdfSample& sample);

    /// Returns where the paths leave, except those that carry no light to there. Valid until
    /// clear().
    std::span<const Exit> find_exits(RayCounts& counts);

  private:
    /// A path that went below a surface.
    struct Entry {
        PathState path;
        Vec3 position;
        BsdfFrame frame;
        const Subsurface* subsurface;
        std::uint32_t material;  ///< material of the surfaces at which it may leave
        std::uint32_t medium;    ///< medium through which it came
        ShutterTime time;
    };

    /// A surface that the probe of an entry hit.
    struct ProbeHit {
        std::uint32_t entry;
        Ray ray;
        Hit hit;
    };

    void send_probes();
    void trace_probes(RayCounts& counts);
    void choose_exits();
    void take_exit(const ProbeHit& met, std::uint32_t count);

    const PathScene& scene_;
    std::vector<Entry> entries_;
    std::deque<Subsurface> textured_;  ///< of entries with textured subsurface scattering
    VertexPoints probe_points_{Decision::probe};
    std::vector<ProbeHit> probes_;      ///< probes in progress
    std::vector<ProbeHit> probe_hits_;  ///< hits on surfaces of the entry's material
    std::vector<Ray> probe_rays_;
    std::vector<Hit> found_;
    std::vector<Exit> exits_;
};

}  // namespace etalon
