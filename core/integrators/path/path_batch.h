#pragma once

#include <deque>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/integrators/path/path_scene.h"
#include "core/integrators/path/path_vertices.h"
#include "core/sampling/vertex_points.h"

namespace etalon {

/// The paths of some camera samples, which are followed together as a wavefront. A wave of rays is
/// intersected and each hit is shaded; the resulting shadow rays, and the rays of the next wave,
/// are collected and traced together. `in_media`: rays are attenuated and scattered by the media
/// that they pass, and shadow rays pass surfaces without a material.
template <bool in_media>
class PathBatch {
  public:
    PathBatch(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
              RayCounts& counts)
        : PathBatch(scene, samples, colors, counts, scene.most_vertices) {}

    /// Follows paths of at most so many scattering vertices, whatever the scene's setting.
    PathBatch(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
              RayCounts& counts, int most_vertices);

    void run();

  private:
    /// State of a path: the contribution of its camera ray, and the data of the last vertex that
    /// are needed to weight the light that the next one finds.
    struct Path {
        std::uint32_t sample;  ///< number in the batch
        std::uint32_t name;    ///< name of its ray, for sample dimensions
        SampleSource source;   ///< source of its random numbers
        Color throughput{1.0F};
        float density = 0;         ///< of the last vertex's rays in this direction, per steradian
        Receiver last{};           ///< the last vertex
        float roulette_scale = 1;  ///< factor of throughput for Russian roulette: the square of the
                                   ///< index that it has been divided by, the number of paths among
                                   ///< which it was, and how much its directions were favoured
        int depth = 0;             ///< number of scattering vertices
        bool specular = true;      ///< no light could have been sampled for that direction
        bool last_ray = false;     ///< only emission at its end counts
        bool is_unlit = false;  ///< the ray has passed a surface that hides lights from the vertex
        /// One of the paths split at the first vertex with a smooth lobe, or at the first medium
        /// with a grid.
        bool is_split = false;
    };

    /// Number of paths into which a path is split at its first vertex with a smooth lobe. They
    /// share the camera ray and the light sampled there, which are less noisy than what follows.
    static constexpr std::uint32_t split_factor = 2;

    /// Number of points of a grid medium at which a path is scattered where it first enters one.
    /// Chosen by measurement, like the number of split paths: few paths continue from dark ones.
    static constexpr std::uint32_t split_places = 2, dark_places = 4;

    /// A light sample that a vertex needs.
    struct LightQuery {
        std::uint32_t light;
        float expected_samples;  ///< see PathScene::expected_samples
        Vec2 uv;
        std::size_t number;  ///< among those of the vertex
    };

    /// Unoccluded contribution of a light.
    struct LightContribution {
        std::uint32_t sample;
        Color color;
    };

    /// The media along a shadow ray.
    struct ShadowMedium {
        std::uint32_t medium;  ///< medium in which the rest of the ray begins
        RandomSequence numbers;
    };

    /// A path that went below a surface and leaves it elsewhere.
    struct SubsurfaceEntry {
        Path path;
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

    /// Point where a path leaves a surface from below.
    struct SubsurfaceExit {
        std::uint32_t entry;
        PhysicalSurface surface;
    };

    /// Returns whether a path may be scattered at its next vertex.
    bool may_go_on(const Path& path) const { return !path.last_ray && path.depth < most_vertices_; }

    /// Returns whether a ray's path is scattered by the medium that the ray passes.
    bool is_in_medium(std::size_t ray) const {
        if constexpr (in_media) return flights_[ray] < infinity;
        return false;
    }

    /// Returns whether a ray's path may be scattered at the end of the ray.
    bool may_scatter(std::size_t ray) const {
        return (hits_[ray].primitive != no_index || is_in_medium(ray)) && may_go_on(paths_[ray]);
    }

    /// Returns the number of paths into which the path is split at a smooth lobe.
    std::uint32_t split_count(const Path& path) const {
        return path.is_split || shared_.samples_all ? 1 : split_factor;
    }

    /// Generates the random numbers of all vertices.
    void make_points();
    void clear_points();
    void add_points(const Path& path);
    void make_added_points();
    void add_light_points(const Path& path);
    void shade_all(bool from_camera);
    void shade(std::size_t ray, const VertexNumbers& numbers);
    void scatter_in_medium(std::size_t ray, const VertexNumbers& numbers);

    void add(const Path& path, const Color& color) {
        colors_[path.sample] += path.throughput * color;
    }
    void add_escaped(const Path& path, const Vec3& direction);
    void add_emitted(const Path& path, const PhysicalSurface& at, const Vec3& direction);

    template <class Vertex>
    void sample_lights(Path& path, const Vertex& at);
    template <class Vertex>
    void sample_light(const Path& path, const Vertex& at, const LightQuery& query);
    void add_light_contributions();

    template <class Vertex>
    void scatter(const Path& path, const Vertex& at);
    template <class Vertex>
    void scatter(const Path& path, const Vertex& at, std::size_t split);
    float survival(const Path& path) const;
    bool survives(Path& path, double choice) const;
    void see_lit_regions(const Receiver& at, PathVertex& vertex);

    // Paths below surfaces.
    void enter(const Path& path, const SurfaceVertex& at, const BsdfSample& sample);
    void scatter_below();
    void send_probes();
    void trace_probes();
    void choose_exits();
    void take_exit(const ProbeHit& met, std::uint32_t count);
    void leave(const SubsurfaceExit& exit, const VertexNumbers& numbers);

    // Paths in media.
    void sample_flights();
    void add_flight_points(std::size_t ray);
    void sample_flight(std::size_t ray, std::size_t number);
    bool divides(std::size_t ray) const {
        return split_count(paths_[ray]) > 1 && shared_.media.grid(media_[ray]);
    }
    std::uint32_t places_of(std::size_t ray) const;
    void divide(std::size_t ray, std::size_t number);
    void add_scattered(std::size_t ray, const Path& path, const Vec2& choices);
    void sample_along(std::size_t ray, const RaySegment& segment, const Vec2& choices);
    float flight_share(const MediumVertex& at, const LightQuery& query) const;
    void attenuate_light_contributions();
    void attenuate(std::size_t contribution, const Ray& ray, double end);
    bool passes(std::size_t contribution, Ray& ray, const Hit& hit);

    const PathScene& shared_;
    const CameraSamples& samples_;
    std::span<Color> colors_;
    RayCounts& counts_;
    int most_vertices_;

    std::vector<Ray> rays_, next_rays_;
    std::vector<Path> paths_, next_paths_;
    std::vector<Hit> hits_;
    /// For the rays that may scatter, in their order; and for all paths into which they may be
    /// split.
    VertexPoints light_choices_{Decision::light}, direction_choices_{Decision::direction};
    SeededPoints light_points_;
    std::span<const Vec2> on_lights_;  ///< for each of these, for all samples of all lights

    std::vector<Ray> shadow_rays_;
    std::vector<LightContribution> light_contributions_;
    std::vector<std::uint8_t> blocked_;

    // Paths below surfaces.
    std::vector<SubsurfaceEntry> entries_;
    std::deque<Subsurface> textured_;  ///< of entries with textured subsurface scattering
    VertexPoints probe_points_{Decision::probe};
    std::vector<ProbeHit> probes_;      ///< probes in progress
    std::vector<ProbeHit> probe_hits_;  ///< hits on surfaces of the entry's material
    std::vector<Ray> probe_rays_;
    std::vector<Hit> found_;
    std::vector<SubsurfaceExit> exits_;

    // Paths in media.
    std::vector<std::uint32_t> media_, next_media_;  ///< medium of each ray; no_index for none
    std::vector<double> flights_;  ///< distances of scattering in media; infinity for none
    /// Densities of these distances if a light was sampled along the ray, else 0.
    std::vector<float> flight_densities_;
    VertexPoints flight_points_{Decision::flight};
    std::optional<LitRegionsFrom> lit_regions_;  ///< as seen from the current vertex
    DensityProfile profile_;
    std::vector<ShadowMedium> shadow_media_;
    std::vector<std::uint32_t> passing_;  ///< numbers of shadow rays in progress
    std::vector<Ray> passing_rays_;
    std::vector<Hit> passing_hits_;
};

}  // namespace etalon
