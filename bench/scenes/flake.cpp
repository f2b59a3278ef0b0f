#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/sphereflake_spheres.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

constexpr double coarsest = 60;  ///< least triangles of a sphere, if there are enough
constexpr std::size_t deepest = 3;

/// A sphere of bands of quads with a fan of triangles at each pole.
struct Tessellation {
    explicit Tessellation(double triangles)
        : stacks(static_cast<std::uint32_t>(std::max(2.0, std::round(half_root(triangles))))),
          slices(static_cast<std::uint32_t>(
              std::max(3.0, std::round(triangles / (2 * (stacks - 1)))))) {}

    std::uint32_t stacks, slices;  ///< 2 slices (stacks - 1) triangles

  private:
    /// Returns the number of stacks if there are twice as many slices.
    static double half_root(double triangles) { return (1 + std::sqrt(1 + triangles)) / 2; }
};

void add_sphere(Scene& scene, const Sphere& s, const Tessellation& t) {
    const auto south = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    const std::uint32_t north = south + 1, rings = t.stacks - 1;
    const auto place = [&](double x, double y, double z) {
        scene.geometry.vertices.push_back(s.centre + s.radius * Vec3(x, y, z));
    };
    place(0, -1, 0);
    place(0, 1, 0);
    for (std::uint32_t j = 1; j <= rings; ++j) {
        const double latitude = turn / 2 * (j / double(t.stacks) - 0.5);
        for (std::uint32_t i = 0; i < t.slices; ++i) {
            const double longitude = turn * i / t.slices;
            place(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                  std::cos(latitude) * std::cos(longitude));
        }
    }
    const auto vertex = [&](std::uint32_t i, std::uint32_t ring) {
        return north + 1 + ring * t.slices + i % t.slices;
    };
    for (std::uint32_t i = 0; i < t.slices; ++i) {
        scene.geometry.add(Triangle{{south, vertex(i + 1, 0), vertex(i, 0)}}, 0);
        for (std::uint32_t j = 0; j + 1 < rings; ++j) {
            add_quad(scene,
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
        scene.geometry.add(Triangle{{north, vertex(i, rings - 1), vertex(i + 1, rings - 1)}}, 0);
    }
}

/// Returns the deepest flake whose spheres are not too coarse.
std::vector<Sphere> spheres_for(double triangles) {
    for (std::size_t depth = deepest; depth > 0; --depth) {
        std::vector<Sphere> spheres = sphereflake_spheres(depth);
        if (triangles / static_cast<double>(spheres.size()) >= coarsest) return spheres;
    }
    return sphereflake_spheres(0);
}

}  // namespace

/// Small triangles in clusters, on a floor of two large ones.
Scene flake(std::size_t count) {
    Scene scene = empty_scene({.eye = {2.8, 1.8, 3.4}, .at = {0, 0, 0}});
    const double triangles = std::max(0.0, static_cast<double>(count) - 2);
    const std::vector<Sphere> spheres = spheres_for(triangles);
    const Tessellation tessellation(triangles / static_cast<double>(spheres.size()));
    for (const Sphere& s : spheres) add_sphere(scene, s, tessellation);
    add_sheet(scene, {1, 1}, [](double x, double y) { return Vec3(12 * x - 6, -1, 6 - 12 * y); });
    return scene;
}

}  // namespace etalon::bench
