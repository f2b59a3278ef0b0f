#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/catch.h"
#include "tests/scenes/generated_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

using Key = std::tuple<double, double, double>;
Key key(const Vec3& v) {
    return {v.x, v.y, v.z};
}

/// Distance between the segments ab and cd, by alternating projection onto each (it converges to
/// the minimum of a convex function; a thousand steps are ample here).
double distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto nearest = [](const Vec3& p, const Vec3& from, const Vec3& to) {
        const Vec3 along = to - from;
        return from + std::clamp((p - from).dot(along) / along.length2(), 0.0, 1.0) * along;
    };
    Vec3 p = (a + b) / 2;
    Vec3 q = c;
    for (int k = 0; k < 1000; ++k) {
        q = nearest(p, c, d);
        p = nearest(q, a, b);
    }
    return (p - q).length();
}

bool inside(const Vec2& p, const std::vector<Vec2>& polygon) {
    bool odd = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
            odd = !odd;
        }
    }
    return odd;
}

/// Counts the triangles at each edge of the scene.
std::map<std::pair<Key, Key>, int> edge_uses(const Scene& scene) {
    std::map<std::pair<Key, Key>, int> uses;
    for (const TriangleIndices t : scene.geometry.all<Triangle>()) {
        for (int k = 0; k < 3; ++k) {
            const Key a = key(scene.geometry.vertex(t[k]));
            const Key b = key(scene.geometry.vertex(t[(k + 1) % 3]));
            ++uses[std::minmax(a, b)];
        }
    }
    return uses;
}

std::set<Key> corners(const Scene& scene) {
    std::set<Key> result;
    for (const TriangleIndices t : scene.geometry.all<Triangle>()) {
        for (const auto v : t) result.insert(key(scene.geometry.vertex(v)));
    }
    return result;
}

}  // namespace

TEST_CASE("Every sphere of a flake touches the one that bears it, and none overlap", "[scenes]") {
    const Scene scene = family_scene("sphereflake", 2);
    const auto& spheres = scene.geometry.all<Sphere>();
    std::size_t touching = 0;
    double smallest_gap = infinity;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = (spheres[i].centre - spheres[j].centre).length() -
                               spheres[i].radius - spheres[j].radius;
            smallest_gap = std::min(smallest_gap, gap);
            touching += gap < 1e-12;
        }
    }
    CHECK(smallest_gap > -1e-12);
    CHECK(touching >= spheres.size() - 1);
    CHECK(std::ranges::all_of(spheres,
                              [](const Sphere& s) { return s.centre.y - s.radius > -1e-12; }));
}

TEST_CASE("A mountain has no cracks, and a larger one refines it", "[scenes]") {
    const Scene coarse = family_scene("mountain", 3);
    const Scene fine = family_scene("mountain", 4);
    std::map<int, int> edges;  // by how many triangles they have
    for (const auto& [edge, uses] : edge_uses(fine)) ++edges[uses];
    CHECK(edges == std::map<int, int>{{1, 4 * 16}, {2, (3 * 2 * 256 - 4 * 16) / 2}});
    CHECK(std::ranges::includes(corners(fine), corners(coarse)));
}

TEST_CASE("The parts of a tetrahedron are closed", "[scenes]") {
    const Scene scene = family_scene("tetra", 2);
    // Adjacent parts share vertices only, so every edge belongs to one part, and to two of its
    // faces.
    const auto edges = edge_uses(scene);
    CHECK(edges.size() == 16 * 6);
    CHECK(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 2; }));
}

TEST_CASE("The rings of a knot are linked without touching", "[scenes]") {
    const Scene scene = family_scene("rings", 1);
    const auto& bars = scene.geometry.all<Cone>();
    double nearest = infinity;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (i / 5 == j / 5) continue;  // of one ring
            nearest =
                std::min(nearest, distance(bars[i].base, bars[i].top, bars[j].base, bars[j].top));
        }
    }
    CHECK(nearest > 2 * bars[0].base_radius);
}

TEST_CASE("The teeth of neighbouring gears are in each other's gaps", "[scenes]") {
    const Scene scene = family_scene("gears", 2);
    std::vector<std::vector<Vec2>> outlines;
    std::vector<double> heights;
    for (const Polygon& p : scene.geometry.all<Polygon>()) {
        if (p.corners.size() != 144) continue;
        heights.push_back(p.corners[0].y);
        std::vector<Vec2> outline;
        for (const Vec3& v : p.corners) outline.emplace_back(v.x, v.z);
        outlines.push_back(outline);
    }
    int close = 0;
    int overlaps = 0;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        for (std::size_t j = 0; j < outlines.size(); ++j) {
            if (i == j || heights[i] != heights[j]) continue;
            const Vec2 centre = (outlines[j][0] + outlines[j][72]) / 2;
            for (const Vec2& corner : outlines[i]) {
                overlaps += inside(corner, outlines[j]);
                close += (corner - centre).length() < 0.5;  // the pitch circle's radius
            }
        }
    }
    CHECK(overlaps == 0);
    CHECK(close > 0);
}
