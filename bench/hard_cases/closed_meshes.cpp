#include "bench/hard_cases/closed_meshes.h"

#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

constexpr std::uint32_t rings = 100, segments = 200;

/// Returns the index of a vertex in rows from pole to pole; a pole is a single vertex.
std::uint32_t corner_of(std::uint32_t ring, std::uint32_t segment) {
    if (ring == 0) return 0;
    if (ring == rings) return 1 + (rings - 1) * segments;
    return 1 + (ring - 1) * segments + segment % segments;
}

void add_corners(Scene& scene, const Vec3& centre, const Vec3& radius) {
    scene.geometry.vertices.push_back(rounded(centre + radius * Vec3(0, 0, 1)));
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        const double polar = turn / 2 * ring / rings;
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const Vec3 level = across({0, 0, 1}, turn * segment / segments);
            const Vec3 unit = std::sin(polar) * level + Vec3(0, 0, std::cos(polar));
            scene.geometry.vertices.push_back(rounded(centre + radius * unit));
        }
    }
    scene.geometry.vertices.push_back(rounded(centre - radius * Vec3(0, 0, 1)));
}

void add_quad(Scene& scene, const std::array<std::uint32_t, 4>& numbers) {
    std::array<Vec3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = scene.geometry.vertices[numbers[k]];
    scene.geometry.add(Polygon{corners}, 0);
}

}  // namespace

Scene uv_sphere(const Vec3& centre, const Vec3& radius, Faces faces) {
    Scene scene;
    add_corners(scene, centre, radius);
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const std::uint32_t a = corner_of(ring, segment), b = corner_of(ring + 1, segment);
            const std::uint32_t c = corner_of(ring + 1, segment + 1);
            const std::uint32_t d = corner_of(ring, segment + 1);
            const bool is_quad = a != d && b != c;
            if (is_quad && faces == Faces::mixed && (ring + segment) % 2 == 0) {
                add_quad(scene, {a, b, c, d});
                continue;
            }
            if (b != c) scene.geometry.add(Triangle{{a, b, c}}, 0);
            if (a != d) scene.geometry.add(Triangle{{a, c, d}}, 0);
        }
    }
    return scene;
}

Scene terrain(const Vec3& corner) {
    Scene scene;
    for (std::uint32_t row = 0; row <= terrain_cells; ++row) {
        for (std::uint32_t column = 0; column <= terrain_cells; ++column) {
            const double height = Random(1, scene.geometry.vertices.size()).uniform();
            scene.geometry.vertices.push_back(rounded(corner + Vec3(column, row, height)));
        }
    }
    for (std::uint32_t row = 0; row < terrain_cells; ++row) {
        for (std::uint32_t column = 0; column < terrain_cells; ++column) {
            const std::uint32_t a = row * (terrain_cells + 1) + column;
            const std::uint32_t c = a + terrain_cells + 2;
            scene.geometry.add(Triangle{{a, a + 1, c}}, 0);
            scene.geometry.add(Triangle{{a, c, c - 1}}, 0);
        }
    }
    return scene;
}

}  // namespace etalon::hard
