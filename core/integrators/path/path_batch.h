#pragma once

#include "core/integrators/integrator.h"
#include "core/integrators/path/flight_sampler.h"
#include "core/integrators/path/path_vertices.h"
#include "core/integrators/path/shadow_queue.h"
#include "core/integrators/path/subsurface_queue.h"
#include "core/integrators/path/wave_points.h"

namespace etalon {

/// What is wanted of paths: all light, or only what their camera rays hit.
enum class PathLight { all, emission };

/// The paths of some camera samples, which are followed together as a wavefront. A wave of rays is
/// intersected and each hit is shaded; the resulting shadow rays, and the rays of the next wave,
/// are collected and traced together. `in_media`: rays are attenuated and scattered by the media
/// that they pass, and shadow rays pass surfaces without a material.
template <bool in_media>
class PathBatch {
  public:
    PathBatch(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
              RayCounts& counts, PathLight light = PathLight::all);

    void run();

  private:
    /// A light sample that a vertex needs.
    struct LightQuery {
        std::uint32_t light;
        float expected_samples;  ///< see PathScene::expected_samples
        Vec2 uv;
        std::size_t number;  ///< among those of the vertex
    };

    /// Returns whether a ray's path is scattered by the medium that the ray passes.
    bool is_in_medium(std::size_t ray) const {
        if constexpr (in_media) return flights_.distance(ray) < infinity;
        return false;
    }

    /// Returns whether a ray's path may be scattered at the end of the ray.
    bool may_scatter(std::size_t ray) const {
        return (wave_.hits[ray].primitive != no_index || is_in_medium(ray)) &&
               shared_.may_go_on(wave_.paths[ray]);
    }

    /// Returns whether a path continues beyond a surface without a material. As in pbrt-v3 those of
    /// most vertices end there, unless the ray only looks for the lights of its last vertex.
    bool may_pass(const PathState& path) const {
        return path.depth < shared_.most_vertices || !path.specular || shared_.direct_only;
    }

    void make_points();
    void shade_all(bool from_camera);
    void shade(std::size_t ray, const VertexNumbers& numbers);
    void pass(std::size_t ray, const PhysicalSurface& surface);
    void scatter_in_medium(std::size_t ray, const VertexNumbers& numbers);
    void leave_surfaces();
    void leave(const SubsurfaceQueue::Exit& exit, const VertexNumbers& numbers);

    void add(const PathState& path, const Color& color) {
        colors_[path.sample] += path.throughput * color;
    }
    void add_escaped(const PathState& path, const Vec3& direction);
    void add_emitted(const PathState& path, const PhysicalSurface& at, const Vec3& direction);

    template <class Vertex>
    void sample_lights(PathState& path, const Vertex& at);
    template <class Vertex>
    void sample_light(const PathState& path, const Vertex& at, const LightQuery& query);

    template <class Vertex>
    void scatter(const PathState& path, const Vertex& at);
    template <class Vertex>
    void scatter(const PathState& path, const Vertex& at, std::size_t split);
    float survival(const PathState& path) const;
    bool survives(PathState& path, double choice) const;
    void see_lit_regions(const Receiver& at, PathVertex& vertex);

    const PathScene& shared_;
    std::span<Color> colors_;
    RayCounts& counts_;
    PathWave wave_, next_;
    WavePoints points_;
    ShadowQueue shadows_;
    SubsurfaceQueue below_;
    FlightSampler flights_;
    std::optional<LitRegionsFrom> lit_regions_;  ///< as seen from the current vertex
};

}  // namespace etalon
