#include "core/intersect/oracle/definitions.h"

#include <optional>
#include <span>

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

Crossings define(const Scene&, const Box& b, const Ray& ray) {
    Crossings found;
    if (!is_finite(b.min) || !is_finite(b.max)) return found;
    if (const auto stretch = within_box(b.min, b.max, ray)) {
        found.add({stretch->entry, stretch->exists, Truth::yes});
        found.add({stretch->exit, stretch->exists, Truth::no});
    }
    return found;
}

/// Whether a ray from the origin along d passes through the closed triangle (a, b, c), seen along
/// d, and whether through its outline. Collinear corners make no triangle.
struct Passage {
    Truth inside, on_edge;
};

Passage pass(const TrackedVec& d, const TrackedVec& a, const TrackedVec& b, const TrackedVec& c) {
    const std::array<Tracked, 3> volume = {dot(d, cross(b, c)), dot(d, cross(c, a)),
                                           dot(d, cross(a, b))};
    Truth none_negative = Truth::yes, none_positive = Truth::yes, some_zero = Truth::no,
          all_zero = Truth::yes;
    for (const Tracked& v : volume) {
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
    std::array<TrackedVec, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& corner = scene.vertices[triangle.vertices[i]];
        if (!is_finite(corner)) return found;
        p[i] = TrackedVec(corner) - ray.origin;
    }
    const Truth inside = pass(ray.direction, p[0], p[1], p[2]).inside;
    if (inside == Truth::no) return found;
    const TrackedVec n = cross(p[1] - p[0], p[2] - p[0]);
    const Tracked cosine = dot(n, ray.direction);
    found.add({dot(n, p[0]) / cosine, inside, is_negative(cosine)});
    return found;
}

/// Whether the line along d passes through the closed segment (a, b).
Truth meets_segment(const TrackedVec& d, const TrackedVec& a, const TrackedVec& b) {
    const Truth coplanar = is_zero(dot(d, cross(a, b)));
    if (coplanar == Truth::no) return coplanar;
    return coplanar & !is_positive(dot(cross(a, d), cross(b, d)));
}

/// Even-odd: a point is inside where an odd number of the triangles of a fan cover it. Where it is
/// on a side of the fan, another corner makes another fan.
Truth is_inside(const TrackedVec& d, std::span<const TrackedVec> p) {
    Truth on_outline = Truth::no, edge_on = Truth::yes;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const TrackedVec& next = p[(i + 1) % p.size()];
        on_outline = on_outline | meets_segment(d, p[i], next);
        edge_on = edge_on & is_zero(dot(d, cross(p[i], next)));
    }
    if (on_outline != Truth::no) return on_outline & !edge_on;
    for (const TrackedVec& hub : p) {
        bool odd = false, clear = true;
        for (std::size_t i = 0; i < p.size() && clear; ++i) {
            const Passage passage = pass(d, hub, p[i], p[(i + 1) % p.size()]);
            clear = passage.inside != Truth::unknown && passage.on_edge == Truth::no;
            odd ^= passage.inside == Truth::yes;
        }
        if (clear) return truth(odd);
    }
    return Truth::unknown;
}

/// The outline as the ray sees it, and the plane through the mean corner across Newell's normal,
/// but never out of the corners' box.
Crossings define(const Scene& scene, const Polygon& polygon, const Ray& ray) {
    Crossings found;
    std::vector<TrackedVec> p(polygon.count);
    Box3 box;
    TrackedVec sum, n;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3& corner = scene.vertices[polygon.first + i];
        if (!is_finite(corner)) return found;
        box.extendBy(corner);
        p[i] = TrackedVec(corner) - ray.origin;
        sum = sum + p[i];
        if (i > 0) n = n + cross(p[i - 1] - p[0], p[i] - p[0]);
    }
    const Truth degenerate = is_zero(n.x) & is_zero(n.y) & is_zero(n.z);
    const Truth inside = is_inside(ray.direction, p) & !degenerate;
    const auto stretch = within_box(box.min, box.max, ray);
    if (inside == Truth::no || !stretch) return found;
    const Tracked cosine = dot(n, ray.direction);
    const Tracked passage = dot(n, sum) / (cosine * static_cast<double>(p.size()));
    Crossing crossing(passage, inside, is_negative(cosine));
    if ((passage < stretch->entry) == Truth::yes) crossing.t = stretch->entry;
    if ((stretch->exit < passage) == Truth::yes) crossing.t = stretch->exit;
    found.add(crossing);
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
