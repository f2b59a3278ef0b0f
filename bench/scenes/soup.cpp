#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {

/// Vertices are within one edge length of the triangle's position. The edge length decreases so
/// that the total area, and with it the number of surfaces that a ray passes, is about the same for
/// every count.
Scene soup(std::size_t count) {
    Scene scene = empty_scene();
    Random random(1);
    const double edge = 3 / std::sqrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = random.in_cube();
        const Vec3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        add_triangle(scene, place + edge * a, place + edge * b, place + edge * c);
    }
    return scene;
}

/// Degenerate triangles as a broken exporter writes them: they cannot be hit, and must not affect
/// others.
Scene nan_soup(std::size_t count) {
    Scene scene = soup(count);
    for (std::size_t i = 9; i < count; i += 10) {
        const std::size_t corner = i / 10 % 3, axis = i / 30 % 3;
        scene.geometry.vertices[3 * i + corner][static_cast<int>(axis)] = nan_value;
    }
    return scene;
}

/// Triangles like those of `soup`, in the plane y = 0: boxes have no thickness, and a ray hits many
/// triangles at the same distance.
Scene flat(std::size_t count) {
    Scene scene = empty_scene({.eye = {0.7, 2, 1}});
    Random random(3);
    const double edge = 3 / std::sqrt(static_cast<double>(count));
    const auto in_plane = [](const Vec3& v) { return Vec3(v.x, 0, v.z); };
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = in_plane(random.in_cube());
        const Vec3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        add_triangle(scene, place + edge * in_plane(a), place + edge * in_plane(b),
                     place + edge * in_plane(c));
    }
    return scene;
}

}  // namespace etalon::bench
