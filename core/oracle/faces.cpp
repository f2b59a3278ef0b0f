#include "core/oracle/define.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/numerics/rounding.h"
#include "core/oracle/line_interval.h"

namespace etalon::definition {
namespace {

/// A corner relative to the ray's origin.
struct Corner {
    Corner() = default;
    explicit Corner(const TrackedVec& p)
        : exact(p),
          rounded(static_cast<double>(p.x.value), static_cast<double>(p.y.value),
                  static_cast<double>(p.z.value)) {}

    TrackedVec exact;
    Vec3 rounded;
};

/// Returns d . (a x b): in double if that determines its sign, as it does for all but the few edges
/// at which a ray is aimed.
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

/// Passage of a ray from the origin through a closed triangle (a, b, c): whether it passes through,
/// seen along d, and whether through the outline. Collinear corners make no triangle.
struct Passage {
    Certainty inside, on_edge;
};

/// Decides the passage by the volumes d . (b x c), d . (c x a) and d . (a x b).
Passage pass(const std::array<Tracked, 3>& volumes) {
    Certainty none_negative = Certainty::yes, none_positive = Certainty::yes,
              some_zero = Certainty::no, all_zero = Certainty::yes;
    for (const Tracked& v : volumes) {
        none_negative = none_negative & !is_negative(v);
        none_positive = none_positive & !is_positive(v);
        some_zero = some_zero | is_zero(v);
        all_zero = all_zero & is_zero(v);
    }
    const Certainty inside = (none_negative | none_positive) & !all_zero;
    return {inside, inside & some_zero};
}

}  // namespace

Crossings define(const Geometry& geometry, const Triangle& triangle, const Ray& ray) {
    Crossings found;
    std::array<Corner, 3> c;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 corner = geometry.vertex(triangle.vertices[i]);
        if (!is_finite(corner)) return found;
        c[i] = Corner(TrackedVec(corner) - ray.origin);
    }
    const Vec3& d = ray.direction;
    const Certainty inside =
        pass({volume(d, c[1], c[2]), volume(d, c[2], c[0]), volume(d, c[0], c[1])}).inside;
    if (inside == Certainty::no) return found;
    const TrackedVec& p = c[0].exact;
    const TrackedVec n = cross(c[1].exact - p, c[2].exact - p);
    const Tracked cosine = dot(n, d);
    found.add({dot(n, p) / cosine, inside, is_negative(cosine)});
    return found;
}

namespace {

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

/// Returns whether the line along d passes through the closed side from corner i.
Certainty meets_side(const Outline& outline, std::size_t i) {
    const Certainty coplanar = is_zero(outline.sides[i]);
    if (coplanar == Certainty::no) return coplanar;
    const TrackedVec &a = outline.corners[i].exact, &b = outline.corners[outline.next(i)].exact;
    return coplanar & !is_positive(dot(cross(a, outline.d), cross(b, outline.d)));
}

/// Applies the even-odd rule: a point is inside if an odd number of the triangles of a fan cover
/// it. Unknown if it is on a side of one.
Certainty is_inside_fan(const Outline& outline, const Corner& hub) {
    bool odd = false;
    Tracked spoke = volume(outline.d, hub, outline.corners[0]);
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
        const Tracked next = volume(outline.d, hub, outline.corners[outline.next(i)]);
        const Passage passage = pass({outline.sides[i], -next, spoke});
        if (passage.inside == Certainty::unknown || passage.on_edge != Certainty::no)
            return Certainty::unknown;
        odd ^= passage.inside == Certainty::yes;
        spoke = next;
    }
    return certainty(odd);
}

Certainty is_inside(const Outline& outline) {
    Certainty on_outline = Certainty::no, edge_on = Certainty::yes;
    for (std::size_t i = 0; i < outline.sides.size(); ++i) {
        on_outline = on_outline | meets_side(outline, i);
        edge_on = edge_on & is_zero(outline.sides[i]);
    }
    if (on_outline != Certainty::no) return on_outline & !edge_on;
    for (const Corner& hub : outline.corners) {
        const Certainty inside = is_inside_fan(outline, hub);
        if (inside != Certainty::unknown) return inside;
    }
    return Certainty::unknown;
}

}  // namespace

/// Crosses the outline as the ray sees it, and the plane through the mean corner perpendicular to
/// Newell's normal, but never outside of the corners' box.
Crossings define(const Geometry&, const Polygon& polygon, const Ray& ray) {
    Crossings found;
    std::vector<Corner> corners;
    Box3 box;
    for (const Vec3& corner : polygon.corners) {
        if (!is_finite(corner)) return found;
        box.extendBy(corner);
        corners.emplace_back(TrackedVec(corner) - ray.origin);
    }
    const Outline outline(ray.direction, std::move(corners));
    const Certainty inside = is_inside(outline);
    const auto interval = within_box(box.min, box.max, ray);
    if (inside == Certainty::no || !interval) return found;
    TrackedVec sum, n;
    const TrackedVec& p0 = outline.corners[0].exact;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const TrackedVec& p = outline.corners[i].exact;
        sum = sum + p;
        if (i > 0) n = n + cross(outline.corners[i - 1].exact - p0, p - p0);
    }
    const Certainty degenerate = is_zero(n.x) & is_zero(n.y) & is_zero(n.z);
    const Tracked cosine = dot(n, ray.direction);
    const Tracked passage = dot(n, sum) / (cosine * static_cast<double>(polygon.corners.size()));
    Crossing crossing(passage, inside & !degenerate, is_negative(cosine));
    if ((passage < interval->entry) == Certainty::yes) crossing.t = interval->entry;
    if ((interval->exit < passage) == Certainty::yes) crossing.t = interval->exit;
    if (crossing.exists != Certainty::no) found.add(crossing);
    return found;
}

}  // namespace etalon::definition
