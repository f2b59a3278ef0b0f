#pragma once

#include <span>
#include <vector>

#include "core/shading/hit_order.h"
#include "core/shading/surface_interaction.h"

namespace etalon {

/// Surfaces seen from where rays came, side by side, so that several can be looked at at once: see
/// SurfaceInteraction.
class SeenSurfaces {
  public:
    /// What of a surface is not calculated with.
    struct Traits {
        std::uint32_t ray;  ///< its number in the batch
        std::uint32_t primitive;
        const Material* material;
        Convexity convexity;
        bool scatters;  ///< whether it sends light back
    };

    /// Makes room for so many surfaces, of which there are none yet.
    explicit SeenSurfaces(std::size_t most);

    /// The surfaces at those of `hits` where rays have met one: in whatever order.
    SeenSurfaces(const Scene& scene, std::span<const Ray> rays, std::span<const Hit> hits);

    /// Adds a surface, seen by ray number `ray`, which has that direction.
    void add(const SurfaceInteraction& at, const Vec3& direction, std::uint32_t ray);

    std::size_t size() const { return traits.size(); }

    bool entering(std::size_t i) const { return fronts[i] > 0; }

    /// Padded, of any value there.
    std::vector<Vec3> directions;  ///< of the rays
    std::vector<Vec3> positions, errors, normals, shading_normals;
    std::vector<double> fronts;  ///< 1 where the normal is on the ray's side, else -1
    std::vector<Traits> traits;

  private:
    void set(std::size_t i, const SurfaceInteraction& at);
    void add_run(const Scene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                 std::span<const std::uint32_t> run);
};

}  // namespace etalon
