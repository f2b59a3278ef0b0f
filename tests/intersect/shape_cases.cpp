#include "tests/intersect/shape_cases.h"

#include "core/scene/profiles.h"
#include "core/test_rays/directions.h"
#include "core/test_rays/quadric_points.h"
#include "core/test_rays/revolved_points.h"

namespace etalon {
namespace {

constexpr double pi = 3.14159265358979323846;

/// An odd frame, so that nothing is aligned with the axes by accident.
Vec3 tilted(double x, double y, double z) {
    const Vec3 w = normalized({17, 11, 7});
    Vec3 u, v;
    orthonormal_basis(w, u, v);
    return x * u + y * v + z * w;
}

/// A surface moved in or out of the way by a random amount, from far below a rounding to visible.
double nearly_one(Random& random) {
    return 1 + random.sign() * std::pow(10.0, random.uniform(-18, -1));
}

ShapeCase sphere(const std::string& name, const Sphere& s) {
    ShapeCase c{name, {}, s.centre, s.radius, true, {}, {}};
    c.scene.geometry.add(s, 0);
    c.targets.push_back({"inside", [s](Random& random, const Vec3&) {
                             return s.centre + random.uniform() * s.radius * random.direction();
                         }});
    c.targets.push_back({"surface", [s](Random& random, const Vec3&) {
                             return s.centre + s.radius * random.direction();
                         }});
    c.targets.push_back({"centre", [s](Random&, const Vec3&) { return s.centre; }});
    c.targets.push_back({"silhouette", [s](Random& random, const Vec3& from) {
                             const Vec3 f = from - s.centre;
                             const double distance = std::sqrt(f.dot(f));
                             Vec3 u, v;
                             orthonormal_basis(f / distance, u, v);
                             const double cosine = std::min(1.0, s.radius / distance);
                             const double sine = std::sqrt(1 - cosine * cosine);
                             const double angle = random.uniform(0, 2 * pi);
                             const Vec3 side = std::cos(angle) * u + std::sin(angle) * v;
                             const double reach = s.radius * nearly_one(random);
                             return s.centre + reach * (cosine * f / distance + sine * side);
                         }});
    return c;
}

ShapeCase cone(const std::string& name, const Cone& shape) {
    const Vec3 h = shape.top - shape.base;
    const double length = std::sqrt(h.dot(h));
    const double widest = std::max(shape.base_radius, shape.top_radius);
    ShapeCase c{name, {}, 0.5 * (shape.base + shape.top), length + widest, true, {}, {}};
    c.scene.geometry.add(shape, 0);
    const auto on_circle = [shape, h, length](double s, double angle) {
        Vec3 u, v;
        orthonormal_basis(h / length, u, v);
        const double r = shape.base_radius + s * (shape.top_radius - shape.base_radius);
        return shape.base + s * h + r * (std::cos(angle) * u + std::sin(angle) * v);
    };
    c.targets.push_back({"surface", [=](Random& random, const Vec3&) {
                             return on_circle(random.uniform(), random.uniform(0, 2 * pi));
                         }});
    c.targets.push_back({"axis", [=](Random& random, const Vec3&) {
                             return shape.base + random.uniform(-0.1, 1.1) * h;
                         }});
    c.targets.push_back({"rim", [=](Random& random, const Vec3&) {
                             const double end = random.index(2) == 0 ? 0 : nearly_one(random);
                             return on_circle(end, random.uniform(0, 2 * pi));
                         }});
    c.targets.push_back({"silhouette", [=](Random& random, const Vec3& from) {
                             // Where the normal, outward - (spread / length) axis, is across the
                             // line of sight: outward . f = r + spread (f . h) / length^2.
                             Vec3 u, v;
                             orthonormal_basis(h / length, u, v);
                             const double s = random.uniform();
                             const double spread = shape.top_radius - shape.base_radius;
                             const Vec3 f = from - (shape.base + s * h);
                             const double x = f.dot(u), y = f.dot(v);
                             const double needed = shape.base_radius + s * spread +
                                                   spread * f.dot(h) / (length * length);
                             const double cosine = needed / std::hypot(x, y) * nearly_one(random);
                             const double opening = std::acos(std::clamp(cosine, -1.0, 1.0));
                             return on_circle(s, std::atan2(y, x) + random.sign() * opening);
                         }});
    if (shape.top_radius == 0) {
        c.tips.push_back(shape.top);
        c.targets.push_back({"apex", [=](Random& random, const Vec3&) {
                                 const double miss = std::pow(10.0, random.uniform(-18, 0));
                                 return shape.top + miss * widest * random.direction();
                             }});
    }
    return c;
}

void add_outline_targets(ShapeCase& c, const std::vector<Vec3>& p) {
    c.targets.push_back({"vertex", [p](Random& random, const Vec3&) {
                             return p[static_cast<std::size_t>(random.index(p.size()))];
                         }});
    c.targets.push_back({"edge", [p](Random& random, const Vec3&) {
                             const auto i = static_cast<std::size_t>(random.index(p.size()));
                             const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
                             return a + random.uniform() * (b - a);
                         }});
    c.targets.push_back({"middle", [p](Random& random, const Vec3&) {
                             const auto i = static_cast<std::size_t>(random.index(p.size()));
                             return 0.5 * (p[i] + p[(i + 1) % p.size()]);
                         }});
    c.targets.push_back({"face", [p](Random& random, const Vec3&) {
                             Vec3 sum(0);
                             double weight = 0;
                             for (const Vec3& corner : p) {
                                 const double w = -std::log(1 - random.uniform());
                                 sum += w * corner;
                                 weight += w;
                             }
                             return sum / weight;
                         }});
}

ShapeCase flat(const std::string& name, const std::vector<Vec3>& p) {
    Box3 box;
    for (const Vec3& corner : p) box.extendBy(corner);
    ShapeCase c{name, {}, box.center(), box.size().length() / 2, true, {}, {}};
    c.scene.geometry.vertices.assign(p.begin(), p.end());
    if (p.size() == 3) {
        c.scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    } else {
        c.scene.geometry.add(Polygon{p}, 0);
    }
    add_outline_targets(c, p);
    return c;
}

ShapeCase box(const std::string& name, const Box& b) {
    const Vec3 size = b.max - b.min;
    ShapeCase c{name, {}, 0.5 * (b.min + b.max), size.length() / 2, true, {}, {}};
    c.scene.geometry.add(b, 0);
    // A point with `fixed` of its coordinates on faces: 1 a face, 2 an edge, 3 a corner.
    const auto on_faces = [b, size](Random& random, int fixed) {
        const int first = random.axis();
        Vec3 p;
        for (int i = 0; i < 3; ++i) {
            const int k = (first + i) % 3;
            const double inside = b.min[k] + random.uniform() * size[k];
            p[k] = i >= fixed ? inside : random.index(2) == 0 ? b.min[k] : b.max[k];
        }
        return p;
    };
    const char* const names[] = {"inside", "face", "edge", "corner"};
    for (int fixed = 0; fixed < 4; ++fixed) {
        c.targets.push_back(
            {names[fixed], [=](Random& random, const Vec3&) { return on_faces(random, fixed); }});
    }
    return c;
}

ShapeCase plane(const std::string& name, const Plane& p) {
    ShapeCase c{name, {}, p.point, 1, true, {}, {}};
    c.scene.geometry.add(p, 0);
    c.targets.push_back({"point", [p](Random& random, const Vec3&) {
                             const Vec3 v = random.in_cube();
                             return p.point + 10.0 * v -
                                    10 * v.dot(p.normal) / p.normal.length2() * p.normal;
                         }});
    c.targets.push_back({"grazing", [p](Random& random, const Vec3& from) {
                             const Vec3 v = random.in_cube().cross(p.normal) / p.normal.length();
                             return from + v +
                                    std::pow(10.0, random.uniform(-18, 0)) * random.in_cube();
                         }});
    return c;
}

ShapeCase ring(const std::string& name, const Ring& r) {
    ShapeCase c{name, {}, r.centre, r.outer, true, {}, {}};
    c.scene.geometry.add(r, 0);
    const auto at = [r](double radius, Random& random) {
        return r.centre + radius * across(r.normal.normalized(), random.uniform(0, 2 * pi));
    };
    c.targets.push_back({"surface", [=](Random& random, const Vec3&) {
                             return at(random.uniform(r.inner, r.outer), random);
                         }});
    c.targets.push_back({"hole", [=](Random& random, const Vec3&) {
                             return at(r.inner * random.uniform(), random);
                         }});
    c.targets.push_back({"rim", [=](Random& random, const Vec3&) {
                             return at(random.index(2) == 0 ? r.inner : r.outer, random);
                         }});
    c.targets.push_back({"next to a rim", [=](Random& random, const Vec3&) {
                             const double rim = random.index(2) == 0 ? r.inner : r.outer;
                             return at(rim * nearly_one(random), random);
                         }});
    return c;
}

ShapeCase quadric(const std::string& name, const Quadric& s) {
    ShapeCase c{name, {}, s.clip.center(), s.clip.size().length() / 2, true, {}, {}};
    c.scene.geometry.add(s, 0);
    const QuadricPoints points(s);
    c.targets.push_back(
        {"inside", [=](Random& random, const Vec3&) { return points.in_clip(random); }});
    c.targets.push_back(
        {"surface", [=](Random& random, const Vec3&) { return points.on_surface(random); }});
    c.targets.push_back(
        {"rim", [=](Random& random, const Vec3&) { return points.on_rim(random); }});
    c.targets.push_back({"silhouette", [=](Random& random, const Vec3& from) {
                             return points.silhouette(from, nearly_one(random) - 1, random);
                         }});
    return c;
}

/// The targets of `unit` in the frame of its image.
template <class Shape>
ShapeCase affine(const std::string& name, const Affine& map, const ShapeCase& unit) {
    const Shape shape(map);
    const double size = map.x.length() + map.y.length() + map.z.length();
    ShapeCase c{name, {}, map.point(unit.centre), size, true, {}, {}};
    c.scene.geometry.add(shape, 0);
    for (const Target& target : unit.targets) {
        c.targets.push_back({target.name, [=](Random& random, const Vec3& from) {
                                 const Vec3 seen = shape.frame.vector(from - map.origin);
                                 return shape.frame.point(target.point(random, seen));
                             }});
    }
    return c;
}

ShapeCase ellipsoid(const std::string& name, const Affine& map) {
    return affine<Ellipsoid>("ellipsoid, " + name, map, sphere(name, {{0, 0, 0}, 1}));
}

ShapeCase closed_cylinder(const std::string& name, const Affine& map) {
    ShapeCase unit = cone(name, {{0, 0, 0}, {0, 0, 1}, 1, 1});
    unit.targets.push_back({"cap", [](Random& random, const Vec3&) {
                                const double angle = random.uniform(0, 2 * pi);
                                const double r = std::sqrt(random.uniform());
                                const auto z = static_cast<double>(random.index(2));
                                return Vec3(r * std::cos(angle), r * std::sin(angle), z);
                            }});
    return affine<ClosedCylinder>("closed cylinder, " + name, map, unit);
}

/// The targets are in the frame of its image.
ShapeCase revolved(const std::string& name, const Revolved& s) {
    const Affine& map = s.to_world;
    const double reach = std::max({1.0, std::abs(s.profile.low), std::abs(s.profile.high)});
    const double size = reach * (map.x.length() + map.y.length() + map.z.length());
    const double middle = s.profile.is_flat() ? 0 : 0.5 * (s.profile.low + s.profile.high);
    ShapeCase c{"revolved, " + name, {}, map.point({0, 0, middle}), size, true, {}, {}};
    c.scene.geometry.add(s, 0);
    const RevolvedPoints points(s);
    const auto add = [&](const char* what, auto&& point) {
        c.targets.push_back({what, [=](Random& random, const Vec3& from) {
                                 const Vec3 seen = s.frame.vector(from - map.origin);
                                 return s.frame.point(point(random, seen));
                             }});
    };
    add("surface", [=](Random& random, const Vec3&) { return points.on_surface(random); });
    add("axis", [=](Random& random, const Vec3&) { return points.on_axis(random); });
    add("rim", [=](Random& random, const Vec3&) {
        return points.on_rim(random.index(2) == 0 ? 1 : nearly_one(random), random);
    });
    add("silhouette", [=](Random& random, const Vec3& from) {
        return points.silhouette(from, nearly_one(random), random);
    });
    if (!s.sector.is_whole) {
        add("side", [=](Random& random, const Vec3&) {
            return points.on_side(random.index(2) == 0 ? 1 : nearly_one(random), random);
        });
    }
    if (points.has_tip()) {
        c.tips.push_back(map.point(points.tip()));
        add("tip", [=](Random& random, const Vec3&) {
            return points.tip() + std::pow(10.0, random.uniform(-18, 0)) * random.direction();
        });
    }
    return c;
}

Affine scaling(double x, double y, double z) {
    return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

/// Rotation after which shapes lie askew.
Affine rotation() {
    return {tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1), {0.3, -0.7, 0.45}};
}

/// An affine map of every kind: stretched, sheared, mirrored, ill-conditioned, far away.
struct NamedMap {
    std::string name;
    Affine map;
};
std::vector<NamedMap> affine_maps(const Vec3& far_away) {
    const Affine askew = rotation(), shear{{1, 0, 0}, {0.5, 1, 0}, {-2, 3, 1}};
    const Affine turned{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
    Affine distant = askew * scaling(1, 2, 0.5);
    distant.origin = far_away;
    return {
        {"unit", {}},
        {"odd", askew * scaling(1, 0.5, 2)},
        {"sheared", shear},
        {"mirrored", askew * scaling(-1, 1, 2)},
        {"mirrored and sheared", shear * scaling(1, 1, -0.5)},
        {"needle", askew * scaling(1, 1, 1e4)},
        {"disk", askew * scaling(1, 1, 1e-4)},
        {"condition 1e6", askew * scaling(1, 1e-3, 1e-6) * turned * shear},
        {"condition 1e8", askew * scaling(1e-4, 1e4, 1) * turned * askew},
        {"far from the origin", distant},
    };
}

std::vector<Vec3> star(int points, double inner) {
    std::vector<Vec3> p;
    for (int i = 0; i < 2 * points; ++i) {
        const double r = i % 2 == 0 ? 1 : inner, angle = pi * i / points;
        p.push_back(tilted(r * std::cos(angle), r * std::sin(angle), 0.25));
    }
    return p;
}

std::vector<Vec3> moved(std::vector<Vec3> p, const Vec3& by) {
    for (Vec3& corner : p) corner += by;
    return p;
}

Box3 around(const Vec3& centre, double reach) {
    return {centre - Vec3(reach), centre + Vec3(reach)};
}

using Coefficients = std::array<double, 10>;

/// a x^2 + e y^2 + h z^2 + 2i z + j
constexpr Coefficients upright(double a, double e, double h, double i, double j) {
    return {a, 0, 0, 0, e, 0, 0, h, i, j};
}

constexpr Coefficients sphere_form = upright(1, 1, 1, 0, -1);

/// |p - at|^2 = 1 for p seen from where it is not.
constexpr Coefficients sphere_seen_from_afar(double x, double y, double z) {
    return {1, 0, 0, -x, 1, 0, -y, 1, -z, x * x + y * y + z * z - 1};
}

/// Ellipsoid along the odd frame's axes.
ShapeCase ellipsoid(const std::string& name, const Vec3& centre, const Vec3& radii) {
    const std::array<Vec3, 3> axes = {tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1)};
    Coefficients c{};
    c[9] = -1;
    Vec3 reach2(0);
    for (int k = 0; k < 3; ++k) {
        const Vec3 v = axes[static_cast<std::size_t>(k)] / radii[k];
        const Vec3 step = radii[k] * axes[static_cast<std::size_t>(k)];
        std::size_t next = 0;
        for (int i = 0; i < 3; ++i, ++next) {
            for (int j = i; j < 3; ++j) c[next++] += v[i] * v[j];
        }
        reach2 += step * step;
    }
    const Vec3 reach(std::sqrt(reach2.x), std::sqrt(reach2.y), std::sqrt(reach2.z));
    return quadric(name, {centre, c, {centre - reach, centre + reach}});
}

std::vector<ShapeCase> quadrics() {
    const Vec3 base(0.3, -0.7, 0.45), far_away(148376, 1234, -223423), zero(0);
    ShapeCase cone =
        quadric("quadric, double cone", {base, upright(1, 1, -1, 0, 0), around(base, 1)});
    cone.tips.push_back(base);
    return {
        quadric("quadric, sphere", {base, sphere_form, around(base, 1)}),
        quadric("quadric, sphere far from the origin",
                {far_away, sphere_form, around(far_away, 1)}),
        quadric("quadric, sphere given from afar",
                {zero, sphere_seen_from_afar(100, -200, 50), around({100, -200, 50}, 1)}),
        quadric("quadric, part of a sphere",
                {zero, sphere_form, {{-1, -0.5, -0.25}, {0.5, 1, 0.75}}}),
        quadric("quadric, hollow sphere", {base, upright(-1, -1, -1, 0, 1), around(base, 1)}),
        ellipsoid("quadric, ellipsoid", base, {1, 2, 0.5}),
        quadric("quadric, thin ellipsoid",
                {zero, upright(1, 0.25, 0x1p20, 0, -1), {{-1, -2, -0x1p-10}, {1, 2, 0x1p-10}}}),
        ellipsoid("quadric, ellipsoid far from the origin", far_away, {2, 1, 0.5}),
        quadric("quadric, cylinder", {base, upright(1, 1, 0, 0, -1), around(base, 1)}),
        quadric("quadric, paraboloid", {zero, upright(1, 1, 0, -0.5, 0), {{-1, -1, 0}, {1, 1, 1}}}),
        quadric("quadric, saddle", {base, upright(1, -1, 0, -0.5, 0), around(base, 1)}),
        quadric("quadric, hyperboloid", {base, upright(1, 1, -1, 0, -0.25), around(base, 1)}),
        quadric("quadric, hyperboloid of two sheets",
                {base, upright(-1, -1, 2, 0, -0.25), around(base, 1)}),
        cone,
        quadric("quadric, plane", {base, {0, 0, 0, 1, 0, 0, 2, 0, 3, 0}, around(base, 1)}),
        quadric("quadric, planes that would cross",
                {base, {0, 1, 0, 0, 0, 0, 0, 0, 0, -0.01}, around(base, 1)}),
        quadric("quadric, any",
                {base, {0.3, -0.7, 0.2, 0.1, 0.5, 0.4, -0.2, -0.6, 0.3, -0.2}, around(base, 1)}),
    };
}

/// Each kind of curve, whole and cut, under maps of all kinds.
std::vector<ShapeCase> surfaces_of_revolution(const Vec3& far_away) {
    const Affine askew = rotation(), shear{{1, 0, 0}, {0.5, 1, 0}, {-2, 3, 1}};
    const Affine turned{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
    Affine distant = askew * scaling(1, 1, 0.5);
    distant.origin = far_away;
    const Sector whole(360), quarter(90), half_turn(180), most(300);
    // The line from (1, -0.5, -1) to (1, 0.5, 1).
    const Sector twisted(360, {{1, 0}, {0, 0.5}}), part(240, {{1, 0}, {0, 0.5}});
    Profile line = profiles::hyperboloid(1, 0.25, -1, 1);
    line.along = Profile::Along::line;
    return {
        revolved("sphere cut below", {askew, profiles::sphere(-0.25, 1), whole}),
        revolved("part of a sphere",
                 {askew * scaling(2, 2, 2), profiles::sphere(-0.5, 0.75), most}),
        revolved("part of a sphere, sheared", {shear, profiles::sphere(-1, 1), quarter}),
        revolved("cylinder", {Affine{}, profiles::cylinder(), whole}),
        revolved("cylinder askew", {askew * scaling(1, 1, 3), profiles::cylinder(), whole}),
        revolved("half a cylinder", {askew * scaling(1, 0.5, 3), profiles::cylinder(), half_turn}),
        revolved("quarter of a cylinder, needle",
                 {askew * scaling(1e-3, 1e-3, 10), profiles::cylinder(), quarter}),
        revolved("cylinder far from the origin", {distant, profiles::cylinder(), most}),
        revolved("cone", {Affine{}, profiles::cone(), whole}),
        revolved("cone askew", {askew * scaling(1, 1, 2), profiles::cone(), whole}),
        revolved("part of a cone, mirrored", {askew * scaling(-1, 1, 2), profiles::cone(), most}),
        revolved("paraboloid", {askew, profiles::paraboloid(0), whole}),
        revolved("part of a paraboloid", {shear, profiles::paraboloid(0.25), quarter}),
        revolved("hyperboloid", {askew, profiles::hyperboloid(0.25, 0.75, -1, 1), whole}),
        revolved("part of a hyperboloid",
                 {askew * scaling(1, 0.5, 2), profiles::hyperboloid(0.25, 0.75, -0.5, 1), most}),
        revolved("line turned about the axis", {askew, line, twisted}),
        revolved("part of a line turned about the axis", {askew, line, part}),
        revolved("disk", {shear, profiles::disk(0), whole}),
        revolved("sector of a disk", {askew, profiles::disk(0), quarter}),
        revolved("sector of a ring, far from the origin", {distant, profiles::disk(0.5), most}),
        revolved("condition 1e4", {askew * scaling(1, 0.5, 1e-4) * turned * shear,
                                   profiles::sphere(-0.5, 0.5), half_turn}),
    };
}

/// A straight curve of a small width, as a ray that leaves a bent one may meet it again.
ShapeCase curve(const std::string& name, CurveType type, const Affine& map) {
    BezierCurve c{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto x = static_cast<float>(i) / 3;
        c.points[i] = Vec3f(2 * x - 1, x - 0.5F, 0.25F - x);
    }
    c.widths = {0.03F, 0.02F};
    c.normals = {Vec3f(0, 0, 1), Vec3f(0, 1, 0)};
    c.type = type;
    ShapeCase s{name, {}, map.origin, 1.25 * (map.x.length() + map.y.length() + map.z.length()),
                true, {}, {}};
    s.scene.geometry.add(Curve(c, map), 0);
    // Across the curve at x of its whole length, by `across` of half its width, for an eye at from.
    const auto at = [map](const Vec3& from, double x, double across) {
        const Vec3 centre = map.point({2 * x - 1, x - 0.5, 0.25 - x});
        const Vec3 side = map.vector({2, 1, -1}).cross(centre - from);
        return centre + across * 0.5 * (0.03 - 0.01 * x) * side.normalized();
    };
    s.targets.push_back({"band", [at](Random& random, const Vec3& from) {
                             return at(from, random.uniform(), random.uniform(-1, 1));
                         }});
    s.targets.push_back({"side", [at](Random& random, const Vec3& from) {
                             const double across = random.sign() * nearly_one(random);
                             return at(from, random.uniform(), across);
                         }});
    s.targets.push_back({"end", [at](Random& random, const Vec3& from) {
                             const double end = random.index(2) == 0 ? 0 : nearly_one(random);
                             return at(from, end, random.uniform(-1, 1));
                         }});
    return s;
}

}  // namespace

std::vector<ShapeCase> shape_cases() {
    const Vec3 far_away(148376, 1234, -223423), base(0.3, -0.7, 0.45);
    const std::vector<Vec3> bent = {
        {0, 0, 1e-6}, {2, 0, -1e-6}, {2, 1, 1e-6}, {0.5, 1.5, 0}, {0, 1, -1e-6}};
    const std::vector<Vec3> notched = {{0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {2, 2, 3}, {0, 4, 3}};
    std::vector<ShapeCase> cases = {
        sphere("sphere", {{0.3, -0.7, 0.45}, 1}),
        sphere("sphere, planet", {{0, 0, -6.4e6}, 6.4e6}),
        sphere("sphere, far from the origin", {far_away, 2}),
        cone("cylinder", {base, base + tilted(0, 0, 21.4), 1, 1}),
        cone("cylinder along an axis", {{0, 0, 0}, {0, 3, 0}, 0.5, 0.5}),
        cone("cylinder, needle", {base, base + tilted(0, 0, 1e3), 1e-3, 1e-3}),
        cone("cone", {base, base + tilted(0, 0, 2), 1, 0}),
        cone("cone along an axis", {{0, 0, 0}, {0, 0, 2}, 1, 0}),
        cone("cone, truncated", {base, base + tilted(0, 0, 3), 0.5, 1.5}),
        cone("cone, all but a cylinder", {base, base + tilted(0, 0, 3), 1, 1 + 0x1p-40}),
        cone("cone, all but a disk", {base, base + tilted(0, 0, 1e-4), 1, 0}),
        cone("cone, far from the origin", {far_away, far_away + tilted(0, 0, 3), 2, 1}),
        flat("triangle", {tilted(0, 0, 1), tilted(2, 0.25, 1), tilted(0.5, 1.5, 1)}),
        flat("triangle across an axis", {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}),
        flat("triangle, sliver", {tilted(0, 0, 0), tilted(1, 0, 0), tilted(0.5, 1e-9, 0)}),
        flat("triangle, far from the origin",
             moved({{0, 0, 0}, {2, 0.25, 0.5}, {0.5, 1.5, 0}}, far_away)),
        flat("polygon, quad", {tilted(0, 0, 1), tilted(2, 0, 1), tilted(2, 1, 1), tilted(0, 1, 1)}),
        flat("polygon, notched, across an axis", notched),
        flat("polygon, star", star(7, 0.4)),
        flat("polygon, circle", star(40, std::cos(pi / 40))),
        flat("polygon, corners off the plane", bent),
        flat("polygon, far from the origin", moved(star(5, 0.3), far_away)),
        box("box", {{-1, -1, -1}, {1, 1, 1}}),
        box("box, odd", {{0.1, -0.7, 0.3}, {0.2, 1.9, 7.7}}),
        box("box, no thickness", {{-1, 0.1, -1}, {1, 0.1, 2}}),
        box("box, far from the origin", {far_away, far_away + Vec3(1, 2, 0.3)}),
        plane("plane", {tilted(0.2, 0.3, 0.4), tilted(0.1, 0.2, 3)}),
        plane("plane across an axis", {{0, 0, 1}, {0, 0, 1}}),
        plane("plane, far from the origin", {far_away, tilted(0.4, 0.1, 1)}),
        ring("ring", {base, tilted(0, 0, 3), 0.5, 1}),
        ring("ring, far from the origin", {far_away, tilted(0, 0.3, 3), 0.5, 2}),
        ring("ring, full disc across an axis", {{0, 0, 1}, {0, 0, -1}, 0, 2}),
        ring("ring, narrow", {base, tilted(0.1, 0.2, 3), 1 - 0x1p-10, 1}),
    };
    for (ShapeCase& c : quadrics()) cases.push_back(std::move(c));
    for (const auto& [map_name, map] : affine_maps(far_away)) {
        cases.push_back(ellipsoid(map_name, map));
        cases.push_back(closed_cylinder(map_name, map));
    }
    for (ShapeCase& c : surfaces_of_revolution(far_away)) cases.push_back(std::move(c));
    Affine there;
    there.origin = base;
    cases.push_back(curve("curve, flat", CurveType::flat, there));
    cases.push_back(curve("curve, ribbon", CurveType::ribbon, there));
    cases.push_back(curve("curve, cylinder", CurveType::cylinder, there));
    there.origin = far_away;
    cases.push_back(curve("curve, far from the origin", CurveType::cylinder, there));
    return cases;
}

std::vector<DegenerateCase> degenerate_cases() {
    std::vector<DegenerateCase> cases;
    const auto add = [&]<class Shape>(const std::string& name, const Shape& shape) {
        cases.push_back({name, {}, true});
        cases.back().scene.geometry.add(shape, 0);
    };
    add("sphere of radius 0", Sphere{{0, 0, 0}, 0});
    add("sphere of negative radius", Sphere{{0, 0, 0}, -1});
    add("cone of no length", Cone{{0, 0, 0}, {0, 0, 0}, 1, 1});
    add("cone of no width", Cone{{0, 0, -1}, {0, 0, 1}, 0, 0});
    add("cone of negative radius", Cone{{0, 0, -1}, {0, 0, 1}, 1, -1});
    add("box inside out", Box{{1, -1, -1}, {-1, 1, 1}});
    add("box inside out in all axes", Box{{1, 1, 1}, {-1, -1, -1}});
    add("plane without a normal", Plane{{0, 0, 0}, {0, 0, 0}});
    const std::pair<const char*, Affine> singular[] = {
        {"of no height", scaling(1, 1, 0)},
        {"of no width", scaling(0, 1, 1)},
        {"sheared flat", {{1, 2, 3}, {3, 1, 7}, {4, 3, 10}}},
    };
    for (const auto& [how, map] : singular) {
        add(std::string("ellipsoid ") + how, Ellipsoid(map));
        add(std::string("closed cylinder ") + how, ClosedCylinder(map));
        add(std::string("revolved ") + how, Revolved(map, profiles::cylinder(), Sector(90)));
        const BezierCurve line{{Vec3f(0), Vec3f(1), Vec3f(2), Vec3f(3)}, {1, 1}};
        add(std::string("curve ") + how, Curve(line, map));
    }
    add("revolved of no height", Revolved({}, profiles::sphere(0.5, 0.5), Sector(360)));
    add("revolved upside down", Revolved({}, profiles::sphere(0.5, -0.5), Sector(360)));
    add("revolved by no angle", Revolved({}, profiles::cylinder(), Sector(0)));
    add("revolved of the axis", Revolved({}, profiles::hyperboloid(0, 0, -1, 1), Sector(360)));
    add("revolved of nothing but holes", Revolved({}, profiles::disk(1), Sector(360)));

    add("ring without a normal", Ring{{0, 0, 0}, {0, 0, 0}, 0, 1});
    add("ring of no width", Ring{{0, 0, 0}, {0, 0, 1}, 0, 0});
    add("ring inside out", Ring{{0, 0, 0}, {0, 0, 1}, 1, 0.5});
    add("ring of negative radius", Ring{{0, 0, 0}, {0, 0, 1}, -0.5, 1});
    add("curve of no width", Curve({{Vec3f(0), Vec3f(1), Vec3f(2), Vec3f(3)}, {0, 0}}, Affine{}));
    add("quadric of nothing", Quadric{{0, 0, 0}, {}, around(Vec3(0), 1)});
    add("quadric of a constant",
        Quadric{{0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, around(Vec3(0), 1)});
    add("quadric clipped away", Quadric{{0, 0, 0}, sphere_form, {Vec3(1), Vec3(-1)}});

    const auto add_flat = [&](const std::string& name, const std::vector<Vec3>& p, bool empty) {
        cases.push_back({name, flat(name, p).scene, empty});
    };
    const Vec3 a(-1, 0, 0), b(1, 0, 0), c(3, 0, 0);
    add_flat("triangle of one point", {a, a, a}, false);
    add_flat("triangle on a line", {a, b, c}, false);
    add_flat("triangle with two equal corners", {a, b, b}, false);
    add_flat("polygon of one point", {a, a, a, a}, true);
    add_flat("polygon on a line", {a, b, c, b}, true);
    add_flat("polygon that cancels itself", {{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}, true);
    return cases;
}

}  // namespace etalon
