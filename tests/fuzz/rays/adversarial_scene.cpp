#include "tests/fuzz/rays/adversarial_scene.h"

#include <array>

#include "core/numerics/transforms.h"
#include "core/scene/profiles.h"
#include "core/scene/quadric_form.h"

namespace etalon::fuzz {
namespace {

/// Adds primitives to a geometry, each sharing coordinates with the last one.
class Maker {
  public:
    Maker(const AdversarialNumbers& numbers, Geometry& geometry)
        : numbers_(numbers),
          random_(numbers.random()),
          geometry_(geometry),
          last_(numbers.point()) {}

    void add_any() {
        const auto kind = static_cast<ShapeKind>(random_.index(shape_kinds));
        with_shape(kind, [&]<class Shape>() { add<Shape>(); });
    }

  private:
    template <class Shape>
    void add() {
        const Sides sides = random_.one_in(4) ? static_cast<Sides>(random_.index(3)) : Sides::both;
        const Vec3 p = place();
        if constexpr (std::is_same_v<Shape, Sphere>) {
            geometry_.add(Sphere{p, numbers_.length()}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Triangle>) {
            geometry_.add(triangle(p), 0, sides);
        } else if constexpr (std::is_same_v<Shape, Polygon>) {
            const std::vector<Vec3> outline = corners(p);
            geometry_.add(Polygon{outline}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Box>) {
            Box3 box(p);
            box.extendBy(place());
            geometry_.add(Box{box.min, box.max}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Plane>) {
            if (random_.one_in(4)) geometry_.add(Plane{p, numbers_.direction()}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Cone>) {
            const double radius = random_.one_in(3) ? 0 : numbers_.length();
            geometry_.add(Cone{p, place(), radius, numbers_.length()}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Ring>) {
            const double outer = numbers_.length();
            const double inner = outer * random_.index(5) / 4;
            geometry_.add(Ring{p, numbers_.direction(), inner, outer}, 0, sides);
        } else if constexpr (std::is_same_v<Shape, Quadric>) {
            geometry_.add(quadric(p), 0, sides);
        } else if constexpr (std::is_same_v<Shape, Curve>) {
            const Curve c(curve(), map(p), {random_.index(4), 4});
            if (CurveTransform(c.to_world).exists()) geometry_.add(c, 0, sides);
        } else {
            add_image<Shape>(p, sides);
        }
    }

    template <class Shape>
    void add_image(const Vec3& p, Sides sides) {
        if constexpr (std::is_same_v<Shape, Revolved>) {
            const Revolved s(map(p), profile(), sector());
            if (s.exists()) geometry_.add(s, 0, sides);
        } else {
            const Shape s(map(p));
            if (s.frame.exists()) geometry_.add(s, 0, sides);
        }
    }

    /// Returns a point that shares coordinates with the last one.
    Vec3 place() { return last_ = numbers_.point_beside(last_); }

    Triangle triangle(const Vec3& p) {
        auto& vertices = geometry_.vertices;
        const auto corner = [&](const Vec3& v) {
            if (!vertices.empty() && random_.one_in(3)) return random_.index(vertices.size());
            return geometry_.add_vertex(v);
        };
        const std::uint32_t a = corner(p), b = corner(place()), c = corner(place());
        return Triangle{{a, b, c}};
    }

    /// Returns the corners of a polygon, planar up to rounding, convex or not.
    std::vector<Vec3> corners(const Vec3& p) {
        const Vec3 u = place() - p, v = place() - p;
        std::vector<Vec3> list = {p, p + u, p + u + v, p + v};
        if (random_.one_in(3)) list.insert(list.begin() + 2, p + u * 0.5 + v * 0.25);
        return list;
    }

    Quadric quadric(const Vec3& p) {
        const Vec3 half(numbers_.length(), numbers_.length(), numbers_.length());
        Quadric q{p, {}, {p - half, p + half}};
        for (double& c : q.coefficients) c = random_.index(5) - 2.0;
        q.coefficients = scaled(q.coefficients, numbers_.length());
        return q;
    }

    BezierCurve curve() {
        BezierCurve c{};
        for (Vec3f& p : c.points)
            p = Vec3f(Vec3(random_.index(5), random_.index(5), random_.index(5)) / 4.0);
        for (float& width : c.widths) width = static_cast<float>(random_.index(5) + 1) / 8;
        for (Vec3f& n : c.normals) n = Vec3f(random_.direction());
        c.type = static_cast<CurveType>(random_.index(3));
        return c;
    }

    Profile profile() {
        const double part = random_.index(4) / 4.0;
        const std::array all = {profiles::sphere(-part, 1 - part),
                                profiles::cylinder(),
                                profiles::cone(),
                                profiles::paraboloid(part),
                                profiles::hyperboloid(part, 0.5, -1, 1),
                                profiles::disk(part)};
        return all[random_.index(all.size())];
    }

    Sector sector() { return Sector(random_.one_in(2) ? 360 : 30.0 * (random_.index(12) + 1)); }

  public:
    /// Returns a map that stretches, shears, rotates or mirrors.
    Affine map(const Vec3& origin) {
        const auto axis = [&](int k) {
            Vec3 a(0);
            a[k] = random_.sign() * numbers_.length();
            if (random_.one_in(3)) a[random_.axis()] += numbers_.length();
            return a;
        };
        const int first = random_.axis();
        return {axis(first), axis((first + 1) % 3), axis((first + 2) % 3), origin};
    }

    /// Returns a map of any condition number up to 1e14, whose axes are not aligned.
    Affine ill_conditioned_map(const Vec3& origin) {
        const auto turn = [&] { return rotation(random_.uniform(0, 360), random_.direction()); };
        Vec3 factors(numbers_.length());
        factors[random_.axis()] *= random_.magnitude(-14, 0);
        if (random_.one_in(2)) factors[random_.axis()] *= random_.magnitude(-14, 0);
        Affine map = turn() * scaling(factors) * turn();
        map.origin = origin;
        return map;
    }

    void add_instance() {
        const auto object = static_cast<std::uint32_t>(random_.index(geometry_.objects.size()));
        const Affine start = random_.one_in(3) ? ill_conditioned_map(place()) : map(place());
        if (random_.one_in(3)) {
            geometry_.add_moving_instance({start, map(place()), {}}, object);
        } else {
            geometry_.instances.emplace_back(start, object);
        }
    }

  private:
    const AdversarialNumbers& numbers_;
    Random& random_;
    Geometry& geometry_;
    Vec3 last_;
};

void add_primitives(const AdversarialNumbers& numbers, Geometry& geometry) {
    Maker maker(numbers, geometry);
    for (std::uint32_t i = numbers.random().index(6) + 1; i > 0; --i) maker.add_any();
}

}  // namespace

Scene adversarial_scene(const AdversarialNumbers& numbers) {
    Random& random = numbers.random();
    Scene scene;
    add_primitives(numbers, scene.geometry);
    if (random.one_in(4)) {
        Geometry& object = scene.geometry.objects.emplace_back();
        add_primitives(numbers, object);
        if (object.primitives.empty()) return scene;
        Maker maker(numbers, scene.geometry);
        for (std::uint32_t i = random.index(3) + 1; i > 0; --i) maker.add_instance();
    }
    return scene;
}

}  // namespace etalon::fuzz
