#include "bench/scenes/bench_families.h"
#include "bench/scenes/shared_corners.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {
namespace {

/// Random shapes of about `size` at a random position.
class RandomShapes {
  public:
    RandomShapes(Scene& scene, double size) : scene_(scene), size_(size) {}

    void add(std::size_t number) {
        const Vec3 place = on_grid(random_.in_cube());
        switch (number % 5) {
            case 0:
                return scene_.geometry.add(Sphere{place, size_ * random_.uniform(0.5, 1)}, 0);
            case 1:
                return add_cone(place);
            case 2:
                return add_box(place);
            case 3:
                return add_triangle(place);
            default:
                return add_hexagon(place);
        }
    }

  private:
    Vec3 edge() { return on_grid(size_ * random_.in_cube()); }

    /// Rounds to multiples of 2^-40: sums of a few are exact, so that polygons are planar.
    static Vec3 on_grid(Vec3 v) {
        for (int k = 0; k < 3; ++k) v[k] = std::ldexp(std::round(std::ldexp(v[k], 40)), -40);
        return v;
    }

    void add_cone(const Vec3& base) {
        const double radius = size_ * random_.uniform(0.2, 0.6);
        const Vec3 top = base + 2 * size_ * random_.direction();
        scene_.geometry.add(Cone{base, top, radius, radius * random_.uniform()}, 0);
    }

    void add_box(const Vec3& middle) {
        const Vec3 half = 0.2 * Vec3(size_) + 0.8 * abs(edge());
        scene_.geometry.add(Box{middle - half, middle + half}, 0);
    }

    void add_triangle(const Vec3& corner) {
        const Vec3 u = edge(), v = edge();
        bench::add_triangle(scene_, corner, corner + u, corner + v);
    }

    void add_hexagon(const Vec3& middle) {
        const Vec3 u = edge(), v = edge();
        std::array corners = {u, u + v, v, -u, -u - v, -v};
        for (Vec3& corner : corners) corner += middle;
        scene_.geometry.add(Polygon{corners}, 0);
    }

    Scene& scene_;
    double size_;
    Random random_{7};
};

}  // namespace

Scene mixed(std::size_t count) {
    Scene scene = empty_scene({.eye = {1.5, 1.1, 1.9}});
    RandomShapes shapes(scene, 1.2 / std::sqrt(static_cast<double>(count)));
    for (std::size_t i = 0; i < count; ++i) shapes.add(i);
    return scene;
}

}  // namespace etalon::bench
