#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace etalon {

/// Returns the positions of the corners of the scene's i-th triangle.
inline std::vector<Vec3> corners_of(const Scene& scene, std::size_t i) {
    std::vector<Vec3> corners;
    for (const std::uint32_t v : scene.geometry.all<Triangle>()[i]) {
        corners.push_back(scene.geometry.vertex(v));
    }
    return corners;
}

/// Returns the number of the scene's vertices.
inline std::size_t vertex_count(const Scene& scene) {
    return scene.geometry.vertices.size() + scene.geometry.decimal_vertices.size();
}

/// Returns the normals at the corners of the primitive, which is a triangle; empty if it has none.
inline std::vector<Vec3> corner_normals(const Scene& scene, std::size_t primitive) {
    const Geometry& g = scene.geometry;
    const Triangle t = g.get<Triangle>(g.primitives[primitive]);
    std::vector<Vec3> normals;
    for (std::size_t k = 0; k < 3 && t.normal_offset != no_index; ++k) {
        normals.push_back(g.normals[Geometry::normal_number(t, k)]);
    }
    return normals;
}

}  // namespace etalon
