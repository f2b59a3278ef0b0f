// Meshes whose triangles share corners, as modellers make them.
#pragma once

#include <cmath>

#include "core/scene/scene.h"
#include "core/test_rays/directions.h"

namespace etalon::bench {

/// Adds a triangle with corners of its own.
inline void add_triangle(Scene& scene, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    scene.geometry.vertices.insert(scene.geometry.vertices.end(), {a, b, c});
    scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
}

/// Adds two triangles; the corners are in order around the quad.
inline void add_quad(Scene& scene, const std::array<std::uint32_t, 4>& corners) {
    const auto [a, b, c, d] = corners;
    scene.geometry.add(Triangle{{a, b, c}}, 0);
    scene.geometry.add(Triangle{{a, c, d}}, 0);
}

/// A grid of `columns` x `rows` quads. In a closed sheet the last line of vertices is the first.
struct Sheet {
    std::uint32_t columns, rows;
    bool closes = false;  ///< in both directions
};

/// Adds the sheet whose vertex (i, j) is at point(i / columns, j / rows).
template <class Point>
void add_sheet(Scene& scene, const Sheet& sheet, const Point& point) {
    const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    const std::uint32_t width = sheet.columns + !sheet.closes;
    const std::uint32_t height = sheet.rows + !sheet.closes;
    for (std::uint32_t j = 0; j < height; ++j) {
        for (std::uint32_t i = 0; i < width; ++i) {
            scene.geometry.vertices.push_back(
                point(i / double(sheet.columns), j / double(sheet.rows)));
        }
    }
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
        return first + j % height * width + i % width;
    };
    for (std::uint32_t j = 0; j < sheet.rows; ++j) {
        for (std::uint32_t i = 0; i < sheet.columns; ++i) {
            add_quad(scene,
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
}

}  // namespace etalon::bench
