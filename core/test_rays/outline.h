// Triangles and polygons by their corners.
#pragma once

#include <array>
#include <vector>

#include "core/numerics/random.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Returns the corners of a primitive that is a triangle or a polygon.
class Outline {
  public:
    Outline(const Geometry& geometry, std::uint32_t primitive);

    std::uint32_t size() const { return static_cast<std::uint32_t>(corners_.size()); }
    const Vec3& operator[](std::uint32_t i) const { return corners_[i]; }

  private:
    std::vector<Vec3> corners_;
};

enum class Feature { vertices, edges, middles, points };
inline constexpr std::array features = {Feature::vertices, Feature::edges, Feature::middles,
                                        Feature::points};

/// Returns a random point of the kind: a corner; on an edge a + s (b - a), as rounded; the middle
/// of an edge; within the fan from the first corner, so on the face if it is convex.
Vec3 point_of(const Outline& face, Feature feature, Random& random);

}  // namespace etalon
