// Rays to compare and to time backends with, made from a scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/intersect/intersector.h"
#include "core/scene/scene.h"

namespace etalon {

/// Rays of one kind, made once and then given to every backend.
struct RaySet {
    std::string kind;  ///< "camera", "bounce", "shadow", "aimed" or "random"
    bool occlusion;    ///< asked with occluded() rather than closest()
    std::vector<Ray> rays;
};

inline constexpr std::array ray_kinds = {"camera", "bounce", "shadow", "aimed", "random"};

/// Returns at most about `limit` rays of one of ray_kinds, with hits found by `exact`:
///   camera  through pixel centres of an image of this resolution, evenly thinned; in tiles of
///           16 x 16 if all are taken
///   bounce  from each camera hit, cosine-distributed, on the side of the camera
///   shadow  from each camera hit to each light in turn
///   aimed   at what there is to aim at on the scene's shapes, and at borders between primitives
///           as the camera sees them: see core/test_rays/aimed_rays.h
///   random  chords of the scene's bounding sphere
/// In a moving scene rays have times over the whole shutter interval; those at borders, that of its
/// opening.
RaySet make_ray_set(const std::string& kind, const Scene& scene, const Imath::V2i& resolution,
                    const Intersector& exact, std::size_t limit);

/// Returns half the largest extent of all that is finite; 1 if nothing is.
double half_size(const Geometry& geometry);

}  // namespace etalon
