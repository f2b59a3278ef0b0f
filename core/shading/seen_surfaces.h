#pragma once

#include <span>
#include <vector>

#include "core/intersect/ray_stream.h"
#include "core/shading/hit_order.h"
#include "core/shading/surface_interaction.h"

namespace etalon {

/// Surfaces seen from where rays came, with their components apart, so that several can be looked
/// at at once: see SurfaceInteraction. To be found again and again.
class SeenSurfaces {
  public:
    /// What of a surface is not calculated with.
    struct Traits {
        std::uint32_t ray;  ///< its number in the batch
        const Material* material;
    };

    /// Consecutive surfaces of one material: those from number `first` to before `last`.
    struct MaterialRun {
        const Material* material;
        std::size_t first, last;
    };

    /// Makes room for so many surfaces, of which there are none yet.
    void reset(std::size_t most);

    /// Finds the surfaces at those of `hits` where rays have met one: in whatever order.
    void find(const Scene& scene, const RayStream& rays, std::span<const Hit> hits);

    /// Adds a surface, seen by ray number `ray`, which has that direction.
    void add(const SurfaceInteraction& at, const Vec3& direction, std::uint32_t ray);

    std::size_t size() const { return traits.size(); }

    bool entering(std::size_t i) const { return fronts[i] > 0; }

    /// Padded, of any value there.
    Vec3Buffer directions;  ///< of the rays
    Vec3Buffer positions, errors, normals, shading_normals;
    PaddedColumn<double> fronts;    ///< 1 where the normal is on the ray's side, else -1
    PaddedColumn<double> scatters;  ///< 1 where light is sent back, else 0
    PaddedColumn<double> sends_on;  ///< 0 where no ray is sent on, 1 by a mirror, 2 by glass
    /// See Ray::exclude, of rays that leave on the side of the normal, and on the other.
    PaddedColumn<double> outward_excludes, inward_excludes;
    std::vector<Traits> traits;
    std::vector<MaterialRun> runs;  ///< one after another, of all surfaces

  private:
    void set(std::size_t i, const SurfaceInteraction& at);
    void add_traits(const SurfaceInteraction& any, std::span<const std::uint32_t> numbers);
    void add_run(const Scene& scene, const RayStream& rays, std::span<const Hit> hits,
                 std::span<const std::uint32_t> run);

    HitOrder order_;
};

}  // namespace etalon
