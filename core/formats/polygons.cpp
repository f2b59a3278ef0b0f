// Polygons of any number of corners, concave ones too, flat or with corner normals.
#include <algorithm>
#include <cmath>

#include "core/formats/polygon_normal.h"
#include "core/formats/scene_loader.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Normalizes a vector unless it is of unit length already, so that scenes that are written can be
/// read back unchanged.
Vec3 made_unit_vector(const Vec3& v) {
    return is_of_unit_length(v) ? v : unit_vector(v);
}

void read_corners(SceneLoader& loader, std::size_t count, bool with_normals) {
    auto& [positions, normals] = loader.corners;
    positions.clear();
    normals.clear();
    for (std::size_t i = 0; i < count && loader.in.ok(); ++i) {
        positions.push_back(loader.in.vector("corner"));
        if (with_normals) normals.push_back(loader.in.vector("corner normal"));
    }
}

/// Returns whether the corners just read make a polygon.
bool is_visible(SceneLoader& loader) {
    if (!loader.in.ok()) return false;
    const Vec3 normal = area_normal(loader.corners.positions);
    if (is_finite(normal) && normal != Vec3(0)) return true;
    loader.skip_degenerate("it has no area");
    return false;
}

/// Normalizes the normals. If one is zero the polygon gets none.
void normalize_normals(SceneLoader& loader) {
    std::vector<Vec3>& normals = loader.corners.normals;
    for (Vec3& n : normals) n = made_unit_vector(n);
    if (std::ranges::all_of(normals, [](const Vec3& n) { return is_finite(n); })) return;
    loader.in.warn("degenerate", "'{}' shaded flat: a corner normal is zero", loader.in.keyword());
    normals.clear();
}

void add_triangle(SceneLoader& loader) {
    const auto& [positions, normals] = loader.corners;
    Geometry& geometry = loader.scene.geometry;
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] =
            normals.empty() ? geometry.add_vertex(positions[k])
                            : loader.smooth_vertices.number(geometry, positions[k], normals[k]);
    }
    if (!normals.empty()) triangle.normal_offset = geometry.normal_offset();
    loader.add(triangle, loader.sides());
}

void add_polygon(SceneLoader& loader) {
    const auto& [positions, normals] = loader.corners;
    loader.add(Polygon{positions, normals}, loader.sides());
}

void read(SceneLoader& loader, bool with_normals) {
    Reader& in = loader.in;
    const std::size_t offset = in.tokens().offset();
    const std::size_t count = in.count("number of corners", with_normals ? 6 : 3);
    if (!in.ok()) return;
    read_corners(loader, count, with_normals);
    if (in.ok() && count < 3) {
        in.warn_at(offset, "degenerate", "'{}' left out: {} corners, expected at least 3",
                   in.keyword(), count);
    } else if (is_visible(loader)) {
        normalize_normals(loader);
        count == 3 ? add_triangle(loader) : add_polygon(loader);
    }
}

}  // namespace

void read_polygon(SceneLoader& loader) {
    read(loader, false);
}

void read_patch(SceneLoader& loader) {
    read(loader, true);
}

}  // namespace etalon
