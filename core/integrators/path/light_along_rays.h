// Light of point lights that media scatter along a ray. It is sampled at a point of the ray that
// depends on the light, in addition to the ends of flights; the balance heuristic weights the two
// strategies (Veach 1997).
#pragma once

#include "core/integrators/path/path_vertices.h"
#include "core/integrators/path/shadow_queue.h"

namespace etalon {

/// The part of a ray that is in a medium.
struct MediumSegment {
    RaySegment segment;
    std::uint32_t medium;
    ShutterTime time;
};

/// Adds the light of one point light that arrives along the last ray of a path, if any.
void sample_light_along(const PathScene& scene, const PathState& path, const MediumSegment& along,
                        const Vec2& choices, ShadowQueue& shadows);

/// Returns the share that the ends of flights have in the samples of a point light, of which a
/// vertex takes `expected_samples`.
float share_of_flights(const PathScene& scene, const MediumVertex& at, std::uint32_t light,
                       float expected_samples);

}  // namespace etalon
