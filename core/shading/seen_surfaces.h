#pragma once

#include <span>
#include <vector>

#include "core/intersect/ray_stream.h"
#include "core/shading/hit_order.h"
#include "core/shading/surface_interaction.h"

namespace etalon {

/// Surface interactions of a batch of rays as a structure of arrays, so that vector instructions
/// process several at once: see SurfaceInteraction. Reused from batch to batch.
class SeenSurfaces {
  public:
    /// Data of a surface that needs no vector instructions.
    struct Traits {
        std::uint32_t ray;  ///< its number in the batch
        const Material* material;
    };

    /// Consecutive surfaces of one material: those in [first, last).
    struct MaterialRun {
        const Material* material;
        std::size_t first, last;
    };

    /// Removes all surfaces and makes room for `most` of them.
    void reset(std::size_t most);

    /// Finds the surfaces at the hits, in any order. Misses are left out.
    void find(const Scene& scene, const RayStream& rays, std::span<const Hit> hits);

    /// Adds a surface hit by ray number `ray`, which has that direction.
    void add(const SurfaceInteraction& at, const Vec3& direction, std::uint32_t ray);

    std::size_t size() const { return size_; }

    bool entering(std::size_t i) const { return fronts[i] > 0; }
    bool is_glass(std::size_t i) const { return sends_on[i] == 2; }

    /// One entry for each surface; padded with arbitrary values.
    Vec3Buffer directions;  ///< directions of the rays
    Vec3Buffer positions, errors, normals, shading_normals;
    PaddedColumn<double> fronts;    ///< 1 where the normal is on the ray's side, else -1
    PaddedColumn<double> scatters;  ///< 1 where the material is diffuse or specular, else 0
    PaddedColumn<double> sends_on;  ///< 0 for no secondary ray, 1 for a mirror, 2 for glass
    /// Ray::exclude of rays that leave on the side of the normal, and on the other.
    PaddedColumn<double> outward_excludes, inward_excludes;
    PaddedColumn<Traits> traits;
    std::vector<MaterialRun> runs;  ///< cover all surfaces in order

  private:
    void set(std::size_t i, const SurfaceInteraction& at);
    void add_traits(const SurfaceInteraction& any, std::span<const std::uint32_t> numbers);
    void add_run(const Scene& scene, const RayStream& rays, std::span<const Hit> hits,
                 std::span<const std::uint32_t> run);

    std::size_t size_ = 0;
    HitOrder order_;
};

}  // namespace etalon
