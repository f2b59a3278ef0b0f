#include "tests/backends/scenes.h"

#include <numbers>

#include "bench/hard_cases/random_shapes.h"
#include "core/numerics/random.h"
#include "core/scene/quadric_form.h"
#include "tests/catch.h"

namespace etalon::test {
namespace {

std::uint32_t add_vertices(Scene& scene, std::initializer_list<Vec3> points) {
    const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    scene.geometry.vertices.insert(scene.geometry.vertices.end(), points);
    return first;
}

void add_triangle(Scene& scene, const Vec3& a, const Vec3& b, const Vec3& c, Sides sides) {
    const std::uint32_t first = add_vertices(scene, {a, b, c});
    scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0, sides);
}

/// Adds a concave or convex polygon of 4 to 7 corners around `place`.
void add_polygon(Scene& scene, Random& random, const Vec3& place, double size, Sides sides) {
    Vec3 u, v;
    orthonormal_basis(random.direction(), u, v);
    const std::uint32_t count = 4 + random.index(4);
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const double r = size * random.uniform(0.3, 1);
        corners.push_back(place + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
    scene.geometry.add(Polygon{corners}, 0, sides);
}

/// Adds a random quadric through the centre of its box or near it.
void add_quadric(Scene& scene, Random& random, const Vec3& place, double size, Sides sides) {
    const Vec3 half = abs(random.in_cube(size));
    Quadric s{place, {}, {place - half, place + half}};
    for (double& number : s.coefficients) number = random.uniform(-1, 1);
    s.coefficients[9] *= random.uniform(0, 1);
    s.coefficients = scaled(s.coefficients, size);
    scene.geometry.add(s, 0, sides);
}

/// Returns a map that shears, and in half of all cases mirrors.
Affine any_map(const Vec3& place, double size, Random& random) {
    const Vec3 x = random.in_cube(size), y = random.in_cube(size);
    return {x, y, random.in_cube(size), place};
}

/// Adds a random shape of one kind.
template <class Shape>
void add_shape(Scene& scene, Random& random, double size, Sides sides) {
    const Vec3 place = random.in_cube();
    if constexpr (std::is_same_v<Shape, Sphere>) {
        scene.geometry.add(Sphere{place, size * random.uniform(0.1, 1)}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Triangle>) {
        add_triangle(scene, place, place + random.in_cube(size), place + random.in_cube(size),
                     sides);
    } else if constexpr (std::is_same_v<Shape, Polygon>) {
        add_polygon(scene, random, place, size, sides);
    } else if constexpr (std::is_same_v<Shape, Box>) {
        const Vec3 half = abs(random.in_cube(size));
        scene.geometry.add(Box{place - half, place + half}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Plane>) {
        scene.geometry.add(Plane{3.0 * place, random.direction()}, 0, sides);
    } else if constexpr (std::is_same_v<Shape, Ring>) {
        const double outer = size * random.uniform(0.1, 1);
        scene.geometry.add(Ring{place, random.direction(), outer * random.uniform(0, 0.9), outer},
                           0, sides);
    } else if constexpr (std::is_same_v<Shape, Quadric>) {
        add_quadric(scene, random, place, size, sides);
    } else if constexpr (std::is_same_v<Shape, Ellipsoid>) {
        scene.geometry.add(Ellipsoid(any_map(place, size, random)), 0, sides);
    } else if constexpr (std::is_same_v<Shape, ClosedCylinder>) {
        scene.geometry.add(ClosedCylinder(any_map(place, size, random)), 0, sides);
    } else if constexpr (std::is_same_v<Shape, Revolved>) {
        scene.geometry.add(hard::random_revolved(any_map(place, size, random), random), 0, sides);
    } else if constexpr (std::is_same_v<Shape, Curve>) {
        scene.geometry.add(hard::random_curve(any_map(place, size, random), random), 0, sides);
    } else {
        static_assert(std::is_same_v<Shape, Cone>);
        scene.geometry.add(Cone{place, place + random.in_cube(size), size * random.uniform(0, 0.5),
                                size * random.uniform(0.1, 0.5)},
                           0, sides);
    }
}

/// Adds a shape of number `kind` in the order of ShapeArrays.
void add_shape(Scene& scene, Random& random, ShapeKind kind, double size, Sides sides) {
    with_shape(kind, [&]<class Shape>() { add_shape<Shape>(scene, random, size, sides); });
}

double usual_size(std::size_t count) {
    return 1.5 / std::cbrt(static_cast<double>(count + 1));
}

template <class Shape>
Scene only(std::size_t count) {
    Scene scene;
    Random random(kind_of<Shape>() + 1);
    for (std::size_t i = 0; i < count; ++i) {
        add_shape<Shape>(scene, random, usual_size(count), Sides::both);
    }
    return scene;
}

/// Only one in a hundred is a plane, since planes hide the rest.
ShapeKind any_kind(Random& random) {
    const auto kind = static_cast<ShapeKind>(random.index(shape_kinds));
    const bool keep = kind != kind_of<Plane>() || random.one_in(8);
    return keep ? kind : kind_of<Sphere>();
}

Scene mix(std::size_t count) {
    Scene scene;
    Random random(11);
    for (std::size_t i = 0; i < count; ++i) {
        add_shape(scene, random, any_kind(random), usual_size(count), Sides::both);
    }
    return scene;
}

Scene one_sided(std::size_t count) {
    Scene scene;
    Random random(12);
    for (std::size_t i = 0; i < count; ++i) {
        const auto sides = static_cast<Sides>(random.index(3));
        add_shape(scene, random, any_kind(random), usual_size(count), sides);
    }
    return scene;
}

/// Every shape eight times, with the numbers of the copies far apart.
Scene duplicates(std::size_t count) {
    Scene scene = mix(count / 8 + 1);
    const std::vector<Primitive> once = scene.geometry.primitives.list();
    std::vector<Primitive> all = once;
    for (int copy = 1; copy < 8; ++copy) {
        all.insert(all.end(), once.begin(), once.end());
    }
    Random random(13);
    for (std::size_t i = all.size() - 1; i > 0; --i) {
        std::swap(all[i], all[random.index(i + 1)]);
    }
    scene.geometry.primitives = PrimitiveRuns(all);
    return scene;
}

/// Triangles and boxes with small integer corners in three planes: all kinds of exact ties.
Scene coplanar(std::size_t count) {
    Scene scene;
    Random random(14);
    const auto corner = [&](int axis, double level) {
        Vec3 p(random.index(9), random.index(9), random.index(9));
        p[axis] = level;
        return p;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const int axis = static_cast<int>(random.index(3));
        const double level = 4;
        const Vec3 a = corner(axis, level), b = corner(axis, level), c = corner(axis, level);
        if (random.one_in(6)) {
            Box3 box(a);
            box.extendBy(b);
            scene.geometry.add(Box{box.min, box.max}, 0);
        } else {
            add_triangle(scene, a, b, c, Sides::both);
        }
    }
    return scene;
}

Scene huge_and_tiny(std::size_t count) {
    Scene scene;
    Random random(15);
    for (std::size_t i = 0; i < count; ++i) {
        const double size = random.one_in(20) ? random.magnitude(0, 6) : random.magnitude(-6, -0.5);
        add_shape(scene, random, any_kind(random), size, Sides::both);
    }
    return scene;
}

/// Scene of which two primitives extend far beyond all others.
Scene outliers(std::size_t count) {
    Scene scene = mix(count);
    add_triangle(scene, Vec3(-1, -1, 0.1), Vec3(1, -1, 0), Vec3(0, 1e23, 0), Sides::both);
    scene.geometry.add(Sphere{Vec3(0, 1e12, 1), 1e12}, 0);
    return scene;
}

/// Scene within many primitives of all scales that extend far beyond it, around it and to one side.
Scene far_shell(std::size_t count) {
    Scene scene = mix(count);
    Random random(23);
    for (std::size_t i = 0; i < count / 2; ++i) {
        const double distance = random.magnitude(6, 9);
        const double size = distance * random.magnitude(-3, 0);
        const Vec3 centre = distance * random.direction();
        if (i % 3 == 0) {
            scene.geometry.add(Sphere{centre, size}, 0);
        } else {
            add_triangle(scene, centre, centre + size * random.direction(),
                         centre + size * random.direction(), Sides::both);
        }
    }
    return scene;
}

Scene slivers(std::size_t count) {
    Scene scene;
    Random random(16);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 a = random.in_cube(), along = random.in_cube();
        const Vec3 across = random.in_cube(random.magnitude(-8, -2));
        add_triangle(scene, a, a + along, a + random.uniform(0, 1) * along + across, Sides::both);
    }
    return scene;
}

/// Scene with nothing thicker than a plane.
Scene flat(std::size_t count) {
    Scene scene = mix(0);
    Random random(17);
    const auto in_square = [&](double half) {
        Vec3 p = random.in_cube(half);
        p.z = 0;
        return p;
    };
    const double size = 2 / std::sqrt(static_cast<double>(count + 1));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 a = in_square(1);
        if (random.one_in(3)) {
            const Vec3 half = abs(in_square(size));
            scene.geometry.add(Box{a - half, a + half}, 0);
        } else {
            add_triangle(scene, a, a + in_square(size), a + in_square(size), Sides::both);
        }
    }
    return scene;
}

/// A closed mesh of a sphere: rays from inside always hit it.
Scene closed_mesh(std::size_t count) {
    Scene scene;
    const auto n =
        static_cast<std::uint32_t>(std::max(3.0, std::sqrt(static_cast<double>(count) / 2)));
    for (std::uint32_t row = 0; row <= n; ++row) {
        for (std::uint32_t column = 0; column < n; ++column) {
            const double theta = std::numbers::pi * row / n,
                         phi = 2 * std::numbers::pi * column / n;
            const double ring = row == 0 || row == n ? 0 : std::sin(theta);
            scene.geometry.vertices.emplace_back(
                Vec3f(Vec3(ring * std::cos(phi), ring * std::sin(phi), std::cos(theta))));
        }
    }
    for (std::uint32_t row = 0; row < n; ++row) {
        for (std::uint32_t column = 0; column < n; ++column) {
            const std::uint32_t a = row * n + column, b = row * n + (column + 1) % n;
            scene.geometry.add(Triangle{{a, b, a + n}}, 0);
            scene.geometry.add(Triangle{{b, b + n, a + n}}, 0);
        }
    }
    return scene;
}

}  // namespace

const std::vector<SceneFamily>& scene_families() {
    static const std::vector<SceneFamily> families = {
        {"spheres", only<Sphere>},
        {"triangles", only<Triangle>},
        {"polygons", only<Polygon>},
        {"boxes", only<Box>},
        {"planes", only<Plane>},
        {"cones", only<Cone>},
        {"rings", only<Ring>},
        {"quadrics", only<Quadric>},
        {"ellipsoids", only<Ellipsoid>},
        {"cylinders", only<ClosedCylinder>},
        {"revolved", only<Revolved>},
        {"curves", only<Curve>},
        {"mix", mix},
        {"one_sided", one_sided},
        {"duplicates", duplicates},
        {"coplanar", coplanar},
        {"huge_and_tiny", huge_and_tiny},
        {"outliers", outliers},
        {"far_shell", far_shell},
        {"slivers", slivers},
        {"flat", flat},
        {"closed_mesh", closed_mesh},
        {"far", [](std::size_t n) { return transformed(mix(n), 1, Vec3(1e6, -1e6, 1e6)); }},
        {"far_mesh", [](std::size_t n) { return transformed(closed_mesh(n), 1, Vec3(1e6)); }},
        {"tiny_and_far",
         [](std::size_t n) { return transformed(mix(n), 1e-6, Vec3(5e6, -5e6, 5e6)); }},
        {"minute", [](std::size_t n) { return transformed(mix(n), 1e-30); }},
        {"immense", [](std::size_t n) { return transformed(mix(n), 1e30); }},
    };
    return families;
}

Scene make_scene(const std::string& family, std::size_t count) {
    for (const SceneFamily& f : scene_families()) {
        if (f.name == family) return f.make(count);
    }
    FAIL("no scene family " << family);
    return {};
}

}  // namespace etalon::test
