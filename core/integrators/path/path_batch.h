#pragma once

#include <deque>
#include <vector>

#include "core/integrators/integrator.h"
#include "core/integrators/path/path_scene.h"
#include "core/integrators/path/path_vertices.h"
#include "core/sampling/vertex_points.h"

namespace etalon {

/// The paths of some camera samples, which go on together: a wave of rays is intersected, each hit
/// is shaded on its own, and what it asks (shadow rays) and how it goes on (the next wave) is put
/// beside that of the others. `in_media`: rays are attenuated and scattered by the media that they
/// go through, and shadow rays pass surfaces without a material.
template <bool in_media>
class PathBatch {
  public:
    PathBatch(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
              RayCounts& counts)
        : PathBatch(scene, samples, colors, counts, scene.most_vertices) {}

    /// Follows paths of at most so many vertices that scatter, whatever the scene's setting.
    PathBatch(const PathScene& scene, const CameraSamples& samples, std::span<Color> colors,
              RayCounts& counts, int most_vertices);

    void run();

  private:
    /// A path on its way: what its camera ray will see, and what the last vertex must know to weigh
    /// the light that the next one finds.
    struct Path {
        std::uint32_t sample;  ///< number in the batch
        std::uint32_t name;    ///< of its ray, for sample dimensions
        SampleSource source;   ///< of its choices
        Color throughput{1.0F};
        float density = 0;         ///< of the last vertex's rays in this direction, per steradian
        Receiver last{};           ///< that vertex
        float roulette_scale = 1;  ///< factor of throughput for Russian roulette: the square of the
                                   ///< index that it has been divided by, the number of ways among
                                   ///< which it was, and how much its directions were favoured
        int depth = 0;             ///< number of vertices that scattered
        bool specular = true;      ///< no light could have been asked for that direction
        bool last_ray = false;     ///< only what shines at its end counts
        bool is_split = false;  ///< one of the ways on from the first vertex with a smooth lobe, or
                                ///< one of what passes a medium and what is scattered in it
    };

    /// Number of ways in which a path goes on from its first vertex with a smooth lobe. The
    /// camera's ray and the light asked there are shared by them, and are less noisy than what
    /// comes after.
    static constexpr std::uint32_t split_ways = 2;

    /// Number of places of a grid's medium at which a path is scattered where it first meets one.
    /// By measurement, as the number of ways: from dark ones few paths go on.
    static constexpr std::uint32_t split_places = 2, dark_places = 4;

    /// A direction to a light that a vertex asks for.
    struct Question {
        std::uint32_t light;
        float expected_samples;  ///< see PathScene::expected_samples
        Vec2 uv;
        std::size_t number;  ///< among those of the vertex
    };

    /// What a light gives if nothing is in the way.
    struct Answer {
        std::uint32_t sample;
        Color color;
    };

    /// The media that a shadow ray goes through.
    struct ShadowMedium {
        std::uint32_t medium;  ///< in which the rest of the ray begins
        RandomSequence numbers;
    };

    /// A path that went below a surface and comes out elsewhere.
    struct Entry {
        Path path;
        Vec3 position;
        BsdfFrame frame;
        const Subsurface* subsurface;
        std::uint32_t material;  ///< of the surfaces at which it may come out
        std::uint32_t medium;    ///< through which it came
        ShutterTime time;
    };

    /// A surface that the probe of an entry met.
    struct ProbeHit {
        std::uint32_t entry;
        Ray ray;
        Hit hit;
    };

    /// Where a path comes out from below.
    struct Exit {
        std::uint32_t entry;
        PhysicalSurface surface;
    };

    /// Whether a path may be scattered where it meets something.
    bool may_go_on(const Path& path) const { return !path.last_ray && path.depth < most_vertices_; }

    /// Whether a ray's path is scattered by the medium that the ray goes through.
    bool is_in_medium(std::size_t ray) const {
        if constexpr (in_media) return flights_[ray] < infinity;
        return false;
    }

    /// Whether a ray's path may be scattered where the ray ends.
    bool may_scatter(std::size_t ray) const {
        return (hits_[ray].primitive != no_index || is_in_medium(ray)) && may_go_on(paths_[ray]);
    }

    /// Number of ways in which the path goes on where it meets a smooth lobe.
    std::uint32_t ways_of(const Path& path) const {
        return path.is_split || shared_.asks_all ? 1 : split_ways;
    }

    /// Makes the choices of all vertices.
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
    void ask_lights(Path& path, const Vertex& at);
    template <class Vertex>
    void ask_light(const Path& path, const Vertex& at, const Question& question);
    void add_answers();

    template <class Vertex>
    void scatter(const Path& path, const Vertex& at);
    template <class Vertex>
    void scatter(const Path& path, const Vertex& at, std::size_t way);
    float survival(const Path& path) const;
    bool survives(Path& path, double choice) const;
    void see_lit_regions(const Receiver& at, PathVertex& vertex);

    // Of paths below surfaces.
    void enter(const Path& path, const SurfaceVertex& at, const BsdfSample& sample);
    void scatter_below();
    void send_probes();
    void trace_probes();
    void choose_exits();
    void take_exit(const ProbeHit& met, std::uint32_t count);
    void leave(const Exit& exit, const VertexNumbers& numbers);

    // Of paths in media.
    void fly_all();
    void add_flight_points(std::size_t ray);
    void fly(std::size_t ray, std::size_t number);
    bool divides(std::size_t ray) const {
        return ways_of(paths_[ray]) > 1 && shared_.media.grid(media_[ray]);
    }
    std::uint32_t places_of(std::size_t ray) const;
    void divide(std::size_t ray, std::size_t number);
    void add_scattered(std::size_t ray, const Path& path, const Vec2& choices);
    void ask_along(std::size_t ray, const RaySegment& segment, const Vec2& choices);
    float flight_share(const MediumVertex& at, const Question& question) const;
    void attenuate_answers();
    void attenuate(std::size_t answer, const Ray& ray, double end);
    bool passes(std::size_t answer, Ray& ray, const Hit& hit);

    const PathScene& shared_;
    const CameraSamples& samples_;
    std::span<Color> colors_;
    RayCounts& counts_;
    int most_vertices_;

    std::vector<Ray> rays_, next_rays_;
    std::vector<Path> paths_, next_paths_;
    std::vector<Hit> hits_;
    VertexPoints asked_{Decision::light};  ///< of the rays that may scatter, in their order
    VertexPoints ways_{Decision::way};     ///< of all ways that they may go on
    PointBatch light_points_;
    std::span<const Vec2> on_lights_;  ///< of each of these for all samples of all lights

    std::vector<Ray> shadow_rays_;
    std::vector<Answer> answers_;
    std::vector<std::uint8_t> blocked_;

    // Of paths below surfaces.
    std::vector<Entry> entries_;
    std::deque<Subsurface> textured_;  ///< those of entries that are not the same everywhere
    VertexPoints probe_points_{Decision::probe};
    std::vector<ProbeHit> probes_;      ///< on their way
    std::vector<ProbeHit> probe_hits_;  ///< on surfaces of the entry's material
    std::vector<Ray> probe_rays_;
    std::vector<Hit> found_;
    std::vector<Exit> exits_;

    // Of paths in media.
    std::vector<std::uint32_t> media_, next_media_;  ///< in which rays go; no_index: in none
    std::vector<double> flights_;          ///< where rays are scattered by media; infinity: nowhere
    std::vector<float> flight_densities_;  ///< of those beside which a light was asked, else 0
    VertexPoints flight_points_{Decision::flight};
    std::optional<LitRegionsFrom> lit_regions_;  ///< as the present vertex sees them
    DensityProfile profile_;
    std::vector<ShadowMedium> shadow_media_;
    std::vector<std::uint32_t> passing_;  ///< numbers of shadow rays that are on their way
    std::vector<Ray> passing_rays_;
    std::vector<Hit> passing_hits_;
};

}  // namespace etalon
