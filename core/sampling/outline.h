// Triangles and polygons alike: a face is its corners.
#pragma once

#include <array>
#include <vector>

#include "core/sampling/random.h"
#include "core/scene/scene.h"

namespace etalon {

/// The corners of a primitive that is a triangle or a polygon.
class Outline {
  public:
    /// The scene must outlive the outline.
    Outline(const Scene& scene, std::uint32_t primitive);

    std::uint32_t size() const { return size_; }
    const Vec3& operator[](std::uint32_t i) const {
        return triangle_ != nullptr ? vertices_[triangle_[i]] : vertices_[first_ + i];
    }

  private:
    const Vec3* vertices_;
    const std::uint32_t* triangle_ = nullptr;  ///< the indices of its corners, for a triangle
    std::uint32_t first_ = 0, size_ = 3;
};

enum class Feature { vertices, edges, middles, points };
inline constexpr std::array features = {Feature::vertices, Feature::edges, Feature::middles,
                                        Feature::points};

/// A random point of the kind: a corner; on an edge a + s (b - a), as rounded; the middle of an
/// edge; within the fan from the first corner, so on the face if it is convex.
Vec3 point_of(const Outline& face, Feature feature, Random& random);

}  // namespace etalon
