#include "core/formats/triangulation.h"

#include "core/formats/ear_clipping.h"
#include "core/formats/outline.h"
#include "core/numerics/orientation.h"

namespace etalon {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Returns whether the whole outline turns one way, seen from the first corner.
bool is_fan(const std::vector<Vec2>& p) {
    for (std::size_t i = 2; i < p.size(); ++i) {
        if (!(orientation(p[0], p[i - 1], p[i]) >= 0)) return false;
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
    const std::vector<Vec2> outline = projected_outline(corners);
    return is_fan(outline) ? fan(outline.size()) : clip_ears(outline);
}

}  // namespace etalon
