#pragma once

#include <vector>

#include "core/integrators/integrator.h"
#include "core/integrators/path/path_scene.h"
#include "core/sampling/vertex_points.h"

namespace etalon {

/// The paths of some camera samples, which go on together: a wave of rays is intersected, each hit
/// is shaded on its own, and what it asks (shadow rays) and how it goes on (the next wave) is put
/// beside that of the others.
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
        float density = 0;      ///< of the last vertex's rays in this direction, per steradian
        Receiver last{};        ///< that vertex
        float eta_scale = 1;    ///< square of the index that throughput has been divided by
        int depth = 0;          ///< number of vertices that scattered
        bool specular = true;   ///< no light could have been asked for that direction
        bool last_ray = false;  ///< only what shines at its end counts
        bool is_split = false;  ///< one of the ways on from the first vertex with a smooth lobe
    };

    /// Number of ways in which a path goes on from its first vertex with a smooth lobe. The
    /// camera's ray and the light asked there are shared by them, and are less noisy than what
    /// comes after.
    static constexpr std::uint32_t split_ways = 2;

    /// Where the choices of a vertex are.
    struct Numbers {
        std::size_t vertex = 0;     ///< among those that may scatter
        std::size_t first_way = 0;  ///< among the ways that they may go on
    };

    /// Where a path is scattered.
    struct Vertex {
        const PhysicalSurface& surface;
        Vec3 ns;
        BsdfFrom scattering;  ///< to where the path came from
        Numbers numbers;
        std::uint32_t ways;  ///< in which the path goes on
    };

    /// A direction to a light that a vertex asks for.
    struct Question {
        std::uint32_t light;
        float expected_samples;  ///< see PathScene::expected_samples
        Vec2 uv;
    };

    /// What a light gives if nothing is in the way.
    struct Answer {
        std::uint32_t sample;
        Color color;
    };

    /// Whether a ray's path may be scattered where the ray ends.
    bool may_scatter(std::size_t ray) const {
        const Path& path = paths_[ray];
        return hits_[ray].primitive != no_index && !path.last_ray && path.depth < most_vertices_;
    }

    /// Number of ways in which the path goes on where it meets a smooth lobe.
    std::uint32_t ways_of(const Path& path) const {
        return path.is_split || shared_.asks_all ? 1 : split_ways;
    }

    /// Makes the choices of all vertices.
    void make_points();
    void add_light_points(const Path& path);
    void shade_all(bool from_camera);
    void shade(std::size_t ray, const Numbers& numbers);

    void add(const Path& path, const Color& color) {
        colors_[path.sample] += path.throughput * color;
    }
    void add_escaped(const Path& path, const Vec3& direction);
    void add_emitted(const Path& path, const PhysicalSurface& at, const Vec3& direction);

    void ask_lights(Path& path, const Vertex& at);
    void ask_light(const Path& path, const Vertex& at, const Question& question);
    void add_answers();

    void scatter(const Path& path, const Vertex& at);
    void scatter(const Path& path, const Vertex& at, std::size_t way);
    bool survives(Path& path, double choice) const;

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
};

}  // namespace etalon
