#include "core/formats/triangulation.h"

#include "core/formats/ear_clipping.h"
#include "core/formats/outline.h"
#include "core/formats/polygon_normal.h"

namespace etalon {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Returns whether the whole polygon turns one way, seen from the first corner.
bool is_fan(std::span<const Vec3> p) {
    const Vec3 normal = area_normal(p);
    for (std::size_t i = 2; i < p.size(); ++i) {
        if (!((p[i - 1] - p[0]).cross(p[i] - p[0]).dot(normal) >= 0)) return false;
    }
    return true;
}

Triangles fan(std::size_t count) {
    Triangles triangles;
    for (std::uint32_t i = 2; i < count; ++i) triangles.push_back({0, i - 1, i});
    return triangles;
}

}  // namespace

Triangles triangulate(std::span<const Vec3> corners) {
    return is_fan(corners) ? fan(corners.size()) : clip_ears(projected_outline(corners));
}

}  // namespace etalon
