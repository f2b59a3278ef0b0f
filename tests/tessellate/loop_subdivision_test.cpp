#include "core/tessellate/loop_subdivision.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/numerics/random.h"
#include "core/tessellate/half_edges.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

using Corners = std::vector<std::uint32_t>;

struct Control {
    std::vector<Vec3> points;
    Corners corners;
};

SmoothMesh subdivided(const Control& control, int levels) {
    const Result<SmoothMesh> mesh = loop_subdivision(control.points, control.corners, levels);
    CHECK(mesh.error.empty());
    return mesh.value;
}

std::string error_of(const Control& control, int levels = 1) {
    return loop_subdivision(control.points, control.corners, levels).error;
}

const Control octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                         {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};

const Control tetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                          {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}};

/// Returns a vertex with `valence` neighbours at different heights, which are the mesh's boundary.
Control wheel(unsigned valence) {
    Control c{{Vec3(0)}, {}};
    for (unsigned k = 0; k < valence; ++k) {
        const double angle = 2 * std::numbers::pi * k / valence;
        c.points.push_back({std::cos(angle), std::sin(angle), 0.3 * std::sin(2.7 * k)});
        c.corners.insert(c.corners.end(), {0, 1 + k, 1 + (k + 1) % valence});
    }
    return c;
}

/// A mesh of n x n points in which every inner vertex has six neighbours.
template <class Height>
Control grid(unsigned n, const Height& height) {
    Control c;
    for (unsigned i = 0; i < n; ++i) {
        for (unsigned j = 0; j < n; ++j) c.points.push_back({1.0 * i, 1.0 * j, height(i, j)});
    }
    for (unsigned i = 0; i + 1 < n; ++i) {
        for (unsigned j = 0; j + 1 < n; ++j) {
            const unsigned a = i * n + j, b = a + n;
            c.corners.insert(c.corners.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return c;
}

/// Number of triangles at each edge.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const Corners& corners) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i], b = corners[i % 3 == 2 ? i - 2 : i + 1];
        ++edges[std::minmax({a, b})];
    }
    return edges;
}

bool is_near(const Vec3& a, const Vec3& b, double error) {
    return max_abs(a - b) <= error;
}

}  // namespace

TEST_CASE("a closed mesh stays closed, and a level makes four triangles of each") {
    for (const Control& control : {octahedron, tetrahedron}) {
        std::size_t triangles = control.corners.size() / 3;
        for (int levels = 0; levels < 4; ++levels, triangles *= 4) {
            const SmoothMesh mesh = subdivided(control, levels);
            CHECK(mesh.corners.size() == 3 * triangles);
            CHECK(mesh.points.size() ==
                  triangles / 2 + 2);  // Euler, as there are 3/2 edges a triangle
            CHECK(mesh.normals.size() == mesh.points.size());
            const auto edges = edges_of(mesh.corners);
            CHECK(edges.size() == triangles * 3 / 2);
            for (const auto& [edge, count] : edges) REQUIRE(count == 2);
            CHECK(make_half_edges(mesh.corners, mesh.points.size()).error.empty());
        }
    }
}

TEST_CASE("an open mesh keeps its boundary as an edge loop of twice the length") {
    for (int levels = 0; levels < 4; ++levels) {
        const SmoothMesh mesh = subdivided(grid(5, [](auto, auto) { return 0.0; }), levels);
        const auto edges = edges_of(mesh.corners);
        const auto open = std::ranges::count_if(edges, [](const auto& e) { return e.second == 1; });
        CHECK(open == 16 << levels);
        CHECK(mesh.points.size() - edges.size() + mesh.corners.size() / 3 == 1);
    }
}

TEST_CASE("vertices of a closed mesh go to the same points of the surface from every level") {
    for (const Control& control : {octahedron, tetrahedron}) {
        const SmoothMesh first = subdivided(control, 0);
        for (int levels = 1; levels < 5; ++levels) {
            const SmoothMesh mesh = subdivided(control, levels);
            for (std::size_t v = 0; v < control.points.size(); ++v) {
                CHECK(is_near(mesh.points[v], first.points[v], 1e-15));
            }
        }
    }
    // By hand: 1 / (n + 3 / (8 beta)) is 1/8 for four neighbours and 1/5 for three.
    CHECK(is_near(subdivided(octahedron, 0).points[0], {0.5, 0, 0}, 1e-15));
    CHECK(is_near(subdivided(tetrahedron, 0).points[0], {0.2, 0.2, 0.2}, 1e-15));
}

TEST_CASE("an inner vertex of any valence goes to the same point of the surface from every level") {
    for (const unsigned valence : {3U, 4U, 5U, 6U, 7U, 12U, 100U}) {
        const Control control = wheel(valence);
        const Vec3 expected = subdivided(control, 0).points[0];
        for (int levels = 1; levels < 4; ++levels) {
            CAPTURE(valence, levels);
            CHECK(is_near(subdivided(control, levels).points[0], expected, 1e-14));
        }
    }
}

TEST_CASE(
    "normals point along the axes of symmetry, to the side from which corners run clockwise") {
    for (int levels = 0; levels < 3; ++levels) {
        const SmoothMesh mesh = subdivided(octahedron, levels);
        for (std::size_t v = 0; v < octahedron.points.size(); ++v) {
            const Vec3 n = mesh.normals[v].normalized();
            CHECK(is_near(n, -octahedron.points[v], 1e-12));
        }
    }
}

TEST_CASE("a plane of triangles of six neighbours stays a plane and keeps its inner vertices") {
    const auto tilted = [](unsigned i, unsigned j) { return 0.25 * i - 0.5 * j; };
    const Control control = grid(7, tilted);
    for (int levels = 0; levels < 4; ++levels) {
        const SmoothMesh mesh = subdivided(control, levels);
        for (std::size_t v = 0; v < mesh.points.size(); ++v) {
            const auto& [x, y, z] = mesh.points[v];
            REQUIRE(std::abs(0.25 * x - 0.5 * y - z) < 1e-14);
            const Vec3 n = mesh.normals[v].normalized();
            REQUIRE(is_near(n, Vec3(0.25, -0.5, -1).normalized(), 1e-12));
        }
        for (unsigned i = 2; i < 5; ++i) {
            for (unsigned j = 2; j < 5; ++j) {
                CHECK(is_near(mesh.points[7 * i + j], control.points[7 * i + j], 1e-14));
            }
        }
    }
}

TEST_CASE("a boundary is a curve of its own, whatever is beside it") {
    const auto on_boundary = [](unsigned i, unsigned j) { return i % 4 == 0 || j % 4 == 0; };
    const auto height = [&](unsigned i, unsigned j) {
        return on_boundary(i, j) ? 0.1 * i * j : 0.0;
    };
    const auto other = [&](unsigned i, unsigned j) {
        return on_boundary(i, j) ? 0.1 * i * j : 9.0;
    };
    for (int levels = 0; levels < 3; ++levels) {
        const SmoothMesh a = subdivided(grid(5, height), levels),
                         b = subdivided(grid(5, other), levels);
        std::set<std::uint32_t> boundary;
        for (const auto& [edge, count] : edges_of(a.corners)) {
            if (count == 1) boundary.insert({edge.first, edge.second});
        }
        for (const std::uint32_t v : boundary) CHECK(a.points[v] == b.points[v]);
        CHECK(a.points[12] != b.points[12]);
    }
    // By hand: three fifths of a corner and a fifth of each neighbour.
    CHECK(is_near(subdivided(grid(5, height), 0).points[0], {0.2, 0.2, 0}, 1e-15));
}

TEST_CASE("positions, normals and their order are those of PBRT v3") {
    const Control fan{{{0, 0, 0},
                       {1, 0, 0.5},
                       {0.5, 1, 0},
                       {-0.5, 1, 0.25},
                       {-1, 0, 0},
                       {-0.5, -1, 1},
                       {0.5, -1, 0}},
                      {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6}};
    const SmoothMesh mesh = subdivided(fan, 1);
    REQUIRE(mesh.points.size() == 18);
    const auto check = [&](std::size_t v, const Vec3& point, const Vec3& normal) {
        CAPTURE(v);
        CHECK(is_near(mesh.points[v], point, 1e-6));
        CHECK(is_near(mesh.normals[v], normal, 2e-6));
    };
    check(0, {0.262500018, -0.175000012, 0.087500006}, {0.0658843517, 0.1508573, -0.459498674});
    check(1, {0.737500072, 0.175000012, 0.325000018}, {0.085312508, -0.032031253, -0.167500034});
    check(4, {-0.825000048, 0, 0.21875}, {-0.0332031287, -0.118476562, -0.333489597});
    check(7, {0.50000006, 0, 0.237500012}, {0.52125001, -0.057395827, -0.957916796});
    check(9, {0.260416687, 0.479166657, 0.119791672}, {0.35606277, -0.00442037545, -2.13186598});
    check(13, {-0.473958373, -0.0104166679, 0.1875}, {-0.449414134, -0.788596094, -2.62440276});
    CHECK(Corners(mesh.corners.begin(), mesh.corners.begin() + 12) ==
          Corners{0, 7, 9, 7, 1, 8, 9, 8, 2, 7, 8, 9});
    const SmoothMesh control = subdivided(fan, 0);  // six triangles' ends at a vertex of valence 6
    CHECK(is_near(control.normals[0], {0.0445274785, 0.106393918, -1.28657639}, 2e-6));
    CHECK(is_near(control.normals[6], {-0.480000049, -0.04, -0.720000088}, 2e-6));
}

TEST_CASE("points that no triangle names stay where they are") {
    Control control = octahedron;
    control.points.push_back({7, 8, 9});
    const SmoothMesh mesh = subdivided(control, 2), without = subdivided(octahedron, 2);
    CHECK(mesh.points[6] == Vec3(7, 8, 9));
    CHECK(mesh.normals[6] == Vec3(0));
    CHECK(mesh.points.size() == without.points.size() + 1);
    CHECK(mesh.points[7] == without.points[6]);
}

TEST_CASE("no triangles are no surface, at any level") {
    const SmoothMesh mesh = subdivided({{Vec3(1)}, {}}, 2000000000);
    CHECK(mesh.corners.empty());
    CHECK(mesh.points == std::vector<Vec3>{Vec3(1)});
}

TEST_CASE("a control mesh that is no surface is an error that says where") {
    const std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    CHECK(error_of({p, {0, 1, 5}}) == "triangle 0 names vertex 5, of 5 vertices from 0");
    CHECK(error_of({p, {0, 1, 2, 0, 2, 0xFFFFFFFF}}) ==
          "triangle 1 names vertex 4294967295, of 5 vertices from 0");
    CHECK(error_of({p, {0, 1, 2, 3, 4, 3}}) == "triangle 1 names vertex 3 twice");
    CHECK(error_of({p, {0, 1, 2, 3}}) == "4 indices, which are not three for each triangle");
    CHECK(error_of({p, {0, 1, 2, 1, 0, 3, 0, 1, 4}}) ==
          "more than two triangles meet at the edge of vertices 0 and 1");
    CHECK(error_of({p, {0, 1, 2, 0, 1, 3}}) ==
          "triangles 0 and 1 face opposite sides at their common edge");
}

TEST_CASE("more triangles than a few control points are worth are an error") {
    CHECK(error_of(octahedron, 9) == "9 levels make more than 1048576 triangles of 8");
    CHECK(error_of(octahedron, 2147483647) ==
          "2147483647 levels make more than 1048576 triangles of 8");
}

TEST_CASE("triangles of chance give an error or a mesh of points that there are") {
    Random random(9);
    int meshes = 0;
    for (int i = 0; i < 3000; ++i) {
        Control control;
        for (int k = 0; k < 12; ++k) {
            control.points.push_back({random.uniform(), random.uniform(), random.uniform()});
        }
        const unsigned triangles = 1 + random.index(6);
        for (unsigned k = 0; k < 3 * triangles; ++k) control.corners.push_back(random.index(12));
        const Result<SmoothMesh> mesh = loop_subdivision(control.points, control.corners, 2);
        if (!mesh) continue;
        ++meshes;
        REQUIRE(mesh.value.corners.size() == 48 * triangles);
        for (const std::uint32_t v : mesh.value.corners) REQUIRE(v < mesh.value.points.size());
        for (const Vec3& point : mesh.value.points) REQUIRE(is_finite(point));
    }
    CHECK(meshes > 500);
}
