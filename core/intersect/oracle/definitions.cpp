#include "core/intersect/oracle/definitions.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// A root of A t^2 + 2 B t + C, and whether the form falls there: what is outside where the form is
/// positive is then being entered.
struct Root {
    Tracked t;
    Truth exists, falling;
};
struct Roots {
    std::array<Root, 2> list;
    std::size_t count = 0;
};

Roots solve(const Tracked& a, const Tracked& b, const Tracked& c) {
    Roots roots;
    if ((is_zero(a) & is_zero(b)) == Truth::yes) return roots;  // a constant
    const Tracked discriminant = b * b - a * c;
    if (is_negative(discriminant) == Truth::yes) return roots;
    if (is_positive(discriminant) != Truth::yes) {
        // A tangent, or too close to one to tell: both roots are -B/A to within the unknown.
        const Quad slack = discriminant.error > 0 ? square_root(2 * discriminant.error) : Quad(0);
        const Tracked t = Tracked(-b.value, b.error + slack) / a;
        roots.list[roots.count++] = {t, !is_negative(discriminant), Truth::unknown};
        return roots;
    }
    // A t + B is +-root at the roots; c / q is the one of the sign that B has.
    const Tracked root = square_root(discriminant);
    const bool rising = b.value > 0;
    const Tracked q = rising ? -b - root : root - b;
    roots.list[roots.count++] = {c / q, Truth::yes, truth(!rising)};
    // Where A cannot be told from zero the other root is out of any bounded shape's reach.
    if (is_zero(a) == Truth::no) roots.list[roots.count++] = {q / a, Truth::yes, truth(rising)};
    return roots;
}

/// |o + t d - c| = r. The front is met where the distance shrinks.
Crossings define(const Scene&, const Sphere& s, const Ray& ray) {
    Crossings found;
    if (!(s.radius > 0) || !std::isfinite(s.radius) || !is_finite(s.centre)) return found;
    const TrackedVec d = ray.direction, f = TrackedVec(ray.origin) - s.centre;
    const Tracked r = s.radius;
    const Roots roots = solve(dot(d, d), dot(f, d), dot(f, f) - r * r);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        found.add({root.t, root.exists, root.falling});
    }
    return found;
}

/// Points w from the base, with h the axis, at distance r0 + (r1 - r0) z from the line along h at
/// the height z = w.h / h.h, 0 <= z <= 1. Squared and freed of roots and quotients: hh (hh ww -
/// (wh)^2) = (hh r0 + (r1 - r0) wh)^2.
Crossings define(const Scene&, const Cone& c, const Ray& ray) {
    Crossings found;
    if (!is_finite(c.base) || !is_finite(c.top) || c.base == c.top) return found;
    for (const double r : {c.base_radius, c.top_radius}) {
        if (!(r >= 0) || !std::isfinite(r)) return found;
    }
    if (c.base_radius == 0 && c.top_radius == 0) return found;

    const TrackedVec h = TrackedVec(c.top) - c.base, d = ray.direction;
    const TrackedVec f = TrackedVec(ray.origin) - c.base;
    const Tracked spread = Tracked(c.top_radius) - c.base_radius;
    const Tracked hh = dot(h, h), fh = dot(f, h), dh = dot(d, h);
    const Tracked r0 = hh * c.base_radius + spread * fh, r1 = spread * dh;
    const Roots roots =
        solve(hh * (hh * dot(d, d) - dh * dh) - r1 * r1, hh * (hh * dot(f, d) - fh * dh) - r0 * r1,
              hh * (hh * dot(f, f) - fh * fh) - r0 * r0);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        const Tracked z = fh + root.t * dh;
        const Truth within = (z <= hh) & !is_negative(z);
        found.add({root.t, root.exists & within, root.falling});
    }
    return found;
}

/// n . (o + t d - p) = 0, and not a line in the plane.
Crossings define(const Scene&, const Plane& p, const Ray& ray) {
    Crossings found;
    if (!is_finite(p.point) || !is_finite(p.normal)) return found;
    const TrackedVec n = p.normal;
    const Tracked cosine = dot(n, ray.direction);
    const Tracked distance = dot(n, TrackedVec(p.point) - ray.origin);
    found.add({distance / cosine, !is_zero(cosine), is_negative(cosine)});
    return found;
}

/// The stretch of a line within a closed box, if there may be one.
struct Stretch {
    Tracked entry, exit;
    Truth exists;
};

std::optional<Stretch> within_box(const Vec3& min, const Vec3& max, const Ray& ray) {
    // A plane of the box is met at (plane - o) / d; quotients are compared by their products.
    struct Meeting {
        Tracked distance, speed;
    };
    if (Box3(min, max).isEmpty()) return std::nullopt;
    const auto is_later = [](const Meeting& a, const Meeting& b) {
        return is_positive(a.distance * b.speed - b.distance * a.speed);
    };
    std::array<Meeting, 3> in, out;
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
        const double o = ray.origin[k], d = ray.direction[k];
        if (d == 0) {
            if (!(o >= min[k] && o <= max[k])) return std::nullopt;
            continue;
        }
        const Tracked to_min = Tracked(min[k]) - o, to_max = Tracked(max[k]) - o;
        in[count] = d > 0 ? Meeting{to_min, d} : Meeting{-to_max, -d};
        out[count++] = d > 0 ? Meeting{to_max, d} : Meeting{-to_min, -d};
    }
    std::size_t last_in = 0, first_out = 0;
    Truth exists = Truth::yes;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_later(in[i], in[last_in]) == Truth::yes) last_in = i;
        if (is_later(out[first_out], out[i]) == Truth::yes) first_out = i;
        for (std::size_t j = 0; j < count; ++j) {
            if (i != j) exists = exists & !is_later(in[i], out[j]);
        }
    }
    if (exists == Truth::no) return std::nullopt;
    return Stretch{in[last_in].distance / in[last_in].speed,
                   out[first_out].distance / out[first_out].speed, exists};
}

/// Its ends, as crossings of the solid's surface.
Crossings ends(const std::optional<Stretch>& stretch) {
    Crossings found;
    if (!stretch || stretch->exists == Truth::no) return found;
    found.add({stretch->entry, stretch->exists, Truth::yes});
    found.add({stretch->exit, stretch->exists, Truth::no});
    return found;
}

Crossings define(const Scene&, const Box& b, const Ray& ray) {
    if (!is_finite(b.min) || !is_finite(b.max)) return {};
    return ends(within_box(b.min, b.max, ray));
}

/// A ray in the coordinates that an affine map gives to its unit vectors, by Cramer's rule: origin
/// and direction are what they say times `unit`, the determinant.
struct MappedRay {
    MappedRay(const Affine& map, const Ray& ray) {
        const TrackedVec x = map.x, y = map.y, z = map.z;
        const TrackedVec from = TrackedVec(ray.origin) - map.origin, towards = ray.direction;
        const TrackedVec yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        origin = {dot(yz, from), dot(zx, from), dot(xy, from)};
        direction = {dot(yz, towards), dot(zx, towards), dot(xy, towards)};
        unit = dot(x, yz);
    }

    TrackedVec origin, direction;
    Tracked unit;
};

/// |o + t d| = 1 in the map's coordinates.
Crossings define(const Scene&, const Ellipsoid& e, const Ray& ray) {
    Crossings found;
    if (!is_finite(e.to_world)) return found;
    const MappedRay r(e.to_world, ray);
    const Truth exists = !is_zero(r.unit);
    if (exists == Truth::no) return found;
    const TrackedVec &o = r.origin, &d = r.direction;
    const Roots roots = solve(dot(d, d), dot(o, d), dot(o, o) - r.unit * r.unit);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        found.add({root.t, exists & root.exists, root.falling});
    }
    return found;
}

/// Further than any point that two doubles can name.
const Tracked beyond(Quad(0x1p1023) * Quad(0x1p1023), 0);

/// The stretch of a line where a t^2 + 2 b t + c <= 0, for a >= 0.
Stretch where_not_positive(const Tracked& a, const Tracked& b, const Tracked& c) {
    Stretch stretch{-beyond, beyond, Truth::yes};
    if ((is_zero(a) & is_zero(b)) == Truth::yes) {
        stretch.exists = !is_positive(c);
        return stretch;
    }
    const Roots roots = solve(a, b, c);
    if (roots.count == 0) stretch.exists = Truth::no;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        stretch.exists = stretch.exists & root.exists;
        if (root.falling != Truth::no) stretch.entry = root.t;
        if (root.falling != Truth::yes) stretch.exit = root.t;
    }
    return stretch;
}

/// The stretch of a line where 0 <= start + t rise <= top, for top > 0.
Stretch where_between(const Tracked& start, const Tracked& rise, const Tracked& top) {
    if (is_zero(rise) == Truth::yes) {
        return {-beyond, beyond, (!is_negative(start)) & (start <= top)};
    }
    const Tracked low = -start / rise, high = (top - start) / rise;
    if (rise.value > 0) return {low, high, Truth::yes};
    return {high, low, Truth::yes};
}

Stretch both(const Stretch& a, const Stretch& b) {
    const Tracked& entry = (a.entry < b.entry) == Truth::yes ? b.entry : a.entry;
    const Tracked& exit = (b.exit < a.exit) == Truth::yes ? b.exit : a.exit;
    return {entry, exit, a.exists & b.exists & !(a.exit < b.entry) & !(b.exit < a.entry)};
}

/// x^2 + y^2 <= 1 and 0 <= z <= 1 in the map's coordinates.
Crossings define(const Scene&, const ClosedCylinder& c, const Ray& ray) {
    if (!is_finite(c.to_world)) return {};
    const MappedRay r(c.to_world, ray);
    const Truth exists = !is_zero(r.unit);
    if (exists == Truth::no) return {};
    const TrackedVec &o = r.origin, &d = r.direction;
    const Tracked square = r.unit * r.unit;
    const Stretch side = where_not_positive(d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y,
                                            o.x * o.x + o.y * o.y - square);
    Stretch solid = both(side, where_between(o.z * r.unit, d.z * r.unit, square));
    solid.exists = solid.exists & exists;
    return ends(solid);
}

/// A corner as seen from the ray's origin.
struct Corner {
    Corner() = default;
    explicit Corner(const TrackedVec& p)
        : exact(p),
          rounded(static_cast<double>(p.x.value), static_cast<double>(p.y.value),
                  static_cast<double>(p.z.value)) {}

    TrackedVec exact;
    Vec3 rounded;
};

/// d . (a x b): in double where that is enough to know its sign, as it is for all but the few edges
/// that a ray is aimed at.
Tracked volume(const Vec3& d, const Corner& a, const Corner& b) {
    double sum = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double plus = a.rounded[i] * b.rounded[j], minus = a.rounded[j] * b.rounded[i];
        sum += d[k] * (plus - minus);
        size += std::abs(d[k]) * (std::abs(plus) + std::abs(minus));
    }
    // 2 u from the factors, 6 u from the operations, to first order; and nothing near underflow.
    const double error = 16 * unit_roundoff * size;
    const auto scale = [](const Vec3& v) { return std::max(1.0, max_abs(v)); };
    const bool in_range = size > 0x1p-900 * scale(d) * scale(a.rounded) * scale(b.rounded);
    if (in_range && std::abs(sum) > error) return {sum, error};
    return dot(TrackedVec(d), cross(a.exact, b.exact));
}

/// Of a ray from the origin and a closed triangle (a, b, c): whether it passes through, seen along
/// d, and whether through the outline. Collinear corners make no triangle.
struct Passage {
    Truth inside, on_edge;
};

/// From the volumes d . (b x c), d . (c x a) and d . (a x b).
Passage pass(const std::array<Tracked, 3>& volumes) {
    Truth none_negative = Truth::yes, none_positive = Truth::yes, some_zero = Truth::no,
          all_zero = Truth::yes;
    for (const Tracked& v : volumes) {
        none_negative = none_negative & !is_negative(v);
        none_positive = none_positive & !is_positive(v);
        some_zero = some_zero | is_zero(v);
        all_zero = all_zero & is_zero(v);
    }
    const Truth inside = (none_negative | none_positive) & !all_zero;
    return {inside, inside & some_zero};
}

Crossings define(const Scene& scene, const Triangle& triangle, const Ray& ray) {
    Crossings found;
    std::array<Corner, 3> c;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& corner = scene.vertices[triangle.vertices[i]];
        if (!is_finite(corner)) return found;
        c[i] = Corner(TrackedVec(corner) - ray.origin);
    }
    const Vec3& d = ray.direction;
    const Truth inside =
        pass({volume(d, c[1], c[2]), volume(d, c[2], c[0]), volume(d, c[0], c[1])}).inside;
    if (inside == Truth::no) return found;
    const TrackedVec& p = c[0].exact;
    const TrackedVec n = cross(c[1].exact - p, c[2].exact - p);
    const Tracked cosine = dot(n, d);
    found.add({dot(n, p) / cosine, inside, is_negative(cosine)});
    return found;
}

/// An outline as the ray sees it.
struct Outline {
    Outline(const Vec3& direction, std::vector<Corner> seen)
        : d(direction), corners(std::move(seen)) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            sides.push_back(volume(d, corners[i], corners[next(i)]));
        }
    }

    std::size_t next(std::size_t i) const { return (i + 1) % corners.size(); }

    Vec3 d;
    std::vector<Corner> corners;
    std::vector<Tracked> sides;  ///< volume of corners i and i + 1
};

/// Whether the line along d passes through the closed side from corner i.
Truth meets_side(const Outline& outline, std::size_t i) {
    const Truth coplanar = is_zero(outline.sides[i]);
    if (coplanar == Truth::no) return coplanar;
    const TrackedVec &a = outline.corners[i].exact, &b = outline.corners[outline.next(i)].exact;
    return coplanar & !is_positive(dot(cross(a, outline.d), cross(b, outline.d)));
}

/// Even-odd: a point is inside where an odd number of the triangles of a fan cover it. Unknown
/// where it is on a side of one.
Truth is_inside_fan(const Outline& outline, const Corner& hub) {
    bool odd = false;
    Tracked spoke = volume(outline.d, hub, outline.corners[0]);
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        const Tracked next = volume(outline.d, hub, outline.corners[outline.next(i)]);
        const Passage passage = pass({outline.sides[i], -next, spoke});
        if (passage.inside == Truth::unknown || passage.on_edge != Truth::no) return Truth::unknown;
        odd ^= passage.inside == Truth::yes;
        spoke = next;
    }
    return truth(odd);
}

Truth is_inside(const Outline& outline) {
    Truth on_outline = Truth::no, edge_on = Truth::yes;
    for (std::size_t i = 0; i < outline.sides.size(); ++i) {
        on_outline = on_outline | meets_side(outline, i);
        edge_on = edge_on & is_zero(outline.sides[i]);
    }
    if (on_outline != Truth::no) return on_outline & !edge_on;
    for (const Corner& hub : outline.corners) {
        const Truth inside = is_inside_fan(outline, hub);
        if (inside != Truth::unknown) return inside;
    }
    return Truth::unknown;
}

/// The outline as the ray sees it, and the plane through the mean corner across Newell's normal,
/// but never out of the corners' box.
Crossings define(const Scene& scene, const Polygon& polygon, const Ray& ray) {
    Crossings found;
    std::vector<Corner> corners;
    Box3 box;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3& corner = scene.vertices[polygon.first + i];
        if (!is_finite(corner)) return found;
        box.extendBy(corner);
        corners.emplace_back(TrackedVec(corner) - ray.origin);
    }
    const Outline outline(ray.direction, std::move(corners));
    const Truth inside = is_inside(outline);
    const auto stretch = within_box(box.min, box.max, ray);
    if (inside == Truth::no || !stretch) return found;
    TrackedVec sum, n;
    const TrackedVec& p0 = outline.corners[0].exact;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const TrackedVec& p = outline.corners[i].exact;
        sum = sum + p;
        if (i > 0) n = n + cross(outline.corners[i - 1].exact - p0, p - p0);
    }
    const Truth degenerate = is_zero(n.x) & is_zero(n.y) & is_zero(n.z);
    const Tracked cosine = dot(n, ray.direction);
    const Tracked passage = dot(n, sum) / (cosine * static_cast<double>(polygon.count));
    Crossing crossing(passage, inside & !degenerate, is_negative(cosine));
    if ((passage < stretch->entry) == Truth::yes) crossing.t = stretch->entry;
    if ((stretch->exit < passage) == Truth::yes) crossing.t = stretch->exit;
    if (crossing.exists != Truth::no) found.add(crossing);
    return found;
}

}  // namespace

Crossings crossings(const Scene& scene, std::uint32_t primitive, const Ray& ray) {
    const Primitive& p = scene.primitives[primitive];
    const Ray meant = RayQuery(ray).ray;
    return with_shape(p.kind,
                      [&]<class Shape>() { return define(scene, scene.get<Shape>(p), meant); });
}

}  // namespace etalon
