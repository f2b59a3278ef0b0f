#pragma once

#include "core/integrators/path/path_scene.h"
#include "core/sampling/seeded_points.h"
#include "core/sampling/vertex_points.h"

namespace etalon {

/// Indices of the random numbers of a vertex.
struct VertexNumbers {
    std::size_t vertex = 0;       ///< among the vertices that may scatter
    std::size_t first_split = 0;  ///< among the paths into which they may be split
};

/// The random numbers of all vertices at which the rays of a wave end, which are generated
/// together. The scene must outlive them.
class WavePoints {
  public:
    explicit WavePoints(const PathScene& scene) : scene_(scene) {}

    void clear();

    /// Adds the choices of a path's next vertex.
    void add(const PathState& path);

    /// Generates the numbers of all vertices that were added since clear().
    void make();

    /// Returns the choice of a light at a vertex, and of a point on it, if one light is sampled.
    double light_choice(std::size_t vertex) const { return light_choices_.choices(vertex).x; }
    const Vec2& on_light(std::size_t vertex) const { return light_choices_.place(vertex); }

    /// Returns the points of a vertex on all lights, for all samples of each, if all are sampled.
    std::span<const Vec2> on_all_lights(std::size_t vertex) const {
        const std::size_t count = scene_.lights.samples();
        return on_lights_.subspan(vertex * count, count);
    }

    /// Returns the choices of a lobe and of survival, and the place of a direction.
    const Vec2& direction_choices(std::size_t split) const { return directions_.choices(split); }
    const Vec2& direction(std::size_t split) const { return directions_.place(split); }

  private:
    void add_light_points(const PathState& path);

    const PathScene& scene_;
    VertexPoints light_choices_{Decision::light}, directions_{Decision::direction};
    SeededPoints light_points_;
    std::span<const Vec2> on_lights_;
};

}  // namespace etalon
