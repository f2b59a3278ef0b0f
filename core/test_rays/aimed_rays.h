// Rays at features of a scene where backends are most likely to be wrong.
#pragma once

#include <vector>

#include "core/intersect/intersector.h"
#include "core/render/camera_rays.h"
#include "core/scene/scene.h"

namespace etalon {

/// Returns about `count` rays at silhouettes, edges, corners, rims and tips, see targets_of();
/// every kind of shape has the same share. They come alternately from the eye and from anywhere in
/// `bounds`, with the target at t = 1. None if there are no targets.
std::vector<Ray> rays_at_features(const Scene& scene, const Box3& bounds, std::size_t count);

/// Wherever one pixel sees another primitive than the next one in the list, adds two rays through
/// points between them that are as close as doubles allow, on either side of a border. Stops at
/// `limit` rays.
void add_rays_at_borders(const Intersector& exact, const CameraRays& camera,
                         const std::vector<Vec2>& pixels, std::size_t limit,
                         std::vector<Ray>& rays);

}  // namespace etalon
