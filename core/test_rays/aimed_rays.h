// Rays at the places of a scene where backends are most likely to be wrong.
#pragma once

#include <vector>

#include "core/intersect/intersector.h"
#include "core/render/camera_rays.h"
#include "core/scene/scene.h"

namespace etalon {

/// At silhouettes, edges, corners, rims and tips, see targets_of(); every kind of shape has the
/// same share. By turns from the eye and from anywhere in `bounds`. About `count`, the target at
/// t = 1; none if there is nothing to aim at.
std::vector<Ray> rays_at_features(const Scene& scene, const Box3& bounds, std::size_t count);

/// Wherever one pixel sees another primitive than the next one in the list, adds two rays through
/// points between them that are as close as doubles come, on either side of a border; as long as
/// there are fewer than `limit` rays.
void add_rays_at_borders(const Intersector& exact, const CameraRays& camera,
                         const std::vector<Vec2>& pixels, std::size_t limit,
                         std::vector<Ray>& rays);

}  // namespace etalon
