#pragma once

#include "bench/accuracy/textbook/kernel.h"
#include "core/scene/curve_list.h"

namespace etalon::accuracy {

/// Transforms the curve to axes along the ray, halves it until it is straight, and tests whether a
/// piece is within half the width (Pharr, Jakob & Humphreys 2016, section 3.7). For ray-facing
/// ribbons and tubes.
template <class Real>
struct TextbookCurve {
    using RayForm = PlainRay<Real>;
    using Points = std::array<Vec<Real>, 4>;

    explicit TextbookCurve(const StoredCurve& c) : origin(c.place.to_world.origin) {
        for (std::size_t i = 0; i < 3; ++i) rows[i] = Vec<Real>(c.place.rows[i]);
        for (std::size_t i = 0; i < 4; ++i) points[i] = Vec<Real>(c.curve.points[i]);
        for (std::size_t i = 0; i < 2; ++i) widths[i] = static_cast<Real>(c.curve.widths[i]);
    }

    Real first_hit(const RayForm& ray) const {
        const Vec<Real> o = local(ray.origin - origin), d = local(ray.direction);
        const Real length = std::sqrt(d.dot(d));
        const Vec<Real> z = d / length, chord = points[3] - points[0];
        const Vec<Real> across = z.cross(chord), y = across / std::sqrt(across.dot(across));
        const Vec<Real> x = y.cross(z);
        Points seen;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec<Real> w = points[i] - o;
            seen[i] = {x.dot(w), y.dot(w), z.dot(w)};
        }
        Real nearest = no_root<Real>;
        halve(ray, seen, {0, 1, length, depth_for(seen)}, nearest);
        return nearest;
    }

  private:
    struct Piece {
        Real begin, end, length;
        int depth;
    };

    Vec<Real> local(const Vec<Real>& v) const {
        return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)};
    }
    static Vec<Real> between(const Vec<Real>& a, const Vec<Real>& b, Real part) {
        return (1 - part) * a + part * b;
    }
    Real width_at(Real u) const { return (1 - u) * widths[0] + u * widths[1]; }

    int depth_for(const Points& p) const {
        Real bend = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const Vec<Real> b = p[i] - Real{2} * p[i + 1] + p[i + 2];
            bend = std::max({bend, std::abs(b.x), std::abs(b.y), std::abs(b.z)});
        }
        const Real ratio =
            std::sqrt(Real{2}) * 6 * bend / (8 * Real(0.05) * std::max(widths[0], widths[1]));
        return ratio < 1 ? 0 : std::min(std::ilogb(ratio * 4 / 3) / 2, 10);
    }

    void halve(const RayForm& ray, const Points& p, const Piece& piece, Real& nearest) const {
        if (piece.depth == 0) return pass(ray, p, piece, nearest);
        const Vec<Real> a = between(p[0], p[1], Real(0.5)), b = between(p[1], p[2], Real(0.5)),
                        c = between(p[2], p[3], Real(0.5)), ab = between(a, b, Real(0.5)),
                        bc = between(b, c, Real(0.5)), middle = between(ab, bc, Real(0.5));
        const Real half = (piece.begin + piece.end) / 2;
        halve(ray, {p[0], a, ab, middle}, {piece.begin, half, piece.length, piece.depth - 1},
              nearest);
        halve(ray, {middle, bc, c, p[3]}, {half, piece.end, piece.length, piece.depth - 1},
              nearest);
    }

    static bool beyond(const Vec<Real>& end, const Vec<Real>& next) {
        return (next.y - end.y) * -end.y + end.x * (end.x - next.x) < 0;
    }

    void pass(const RayForm& ray, const Points& p, const Piece& piece, Real& nearest) const {
        if (beyond(p[0], p[1]) || beyond(p[3], p[2])) return;
        const Real along_x = p[3].x - p[0].x, along_y = p[3].y - p[0].y;
        const Real w =
            -(p[0].x * along_x + p[0].y * along_y) / (along_x * along_x + along_y * along_y);
        const Real part = std::clamp(w, Real{0}, Real{1});
        const Vec<Real> a = between(p[0], p[1], part), b = between(p[1], p[2], part),
                        c = between(p[2], p[3], part);
        const Vec<Real> at = between(between(a, b, part), between(b, c, part), part);
        const Real half = width_at((1 - part) * piece.begin + part * piece.end) / 2;
        const Real t = at.z / piece.length;
        const bool is_met = at.x * at.x + at.y * at.y <= half * half && contains(ray, t);
        if (is_met && !(nearest <= t)) nearest = t;
    }

    Vec<Real> origin;
    std::array<Vec<Real>, 3> rows;
    Points points;
    std::array<Real, 2> widths;
};

inline auto textbook_kernels(const Scene&, const StoredCurve& c) {
    return std::tuple{Named{"float textbook", TextbookCurve<float>(c)},
                      Named{"double textbook", TextbookCurve<double>(c)}};
}

}  // namespace etalon::accuracy
