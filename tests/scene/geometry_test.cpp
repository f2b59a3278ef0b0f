#include "core/scene/geometry.h"

#include "core/numerics/random.h"
#include "core/scene/transformed.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

std::array<Vec3, 3> corners(const Geometry& g, std::size_t primitive) {
    const auto [a, b, c] = g.get<Triangle>(g.primitives[primitive]).vertices;
    return {g.vertex(a), g.vertex(b), g.vertex(c)};
}

Vec3 normal(const Geometry& g, std::size_t primitive, std::size_t corner) {
    return g.normals[Geometry::normal_number(g.get<Triangle>(g.primitives[primitive]), corner)];
}

void add_flat(Geometry& g, const std::array<Vec3, 3>& corners) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) t.vertices[k] = g.add_compact_vertex(corners[k]);
    g.add(t, 0);
}

void add_smooth(Geometry& g, const std::array<Vec3, 3>& corners, const Vec3& normal) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) t.vertices[k] = g.add_vertex(corners[k], normal);
    t.normal_offset = g.normal_offset();
    g.add(t, 0);
}

constexpr double third = 1.0 / 3;
const std::array few_digits = {Vec3(0.1, 0.2, 0.3), Vec3(1.5, -2.25, 0), Vec3(9, 8, 7.654321)};
const std::array many_digits = {Vec3(third), Vec3(0, 1, 0), Vec3(1, third, 0)};

Geometry mixture() {
    Geometry g;
    add_flat(g, few_digits);
    add_smooth(g, few_digits, {0, 0, 1});
    add_flat(g, many_digits);
    add_smooth(g, many_digits, {0, 1, 0});
    g.add(Sphere{{1, 2, 3}, 4}, 1);
    g.add(Polygon{few_digits}, 1);
    return g;
}

const std::array star = {Vec3(third, 0, 1), Vec3(2, 1, 1),  Vec3(4, 2, 1),
                         Vec3(2, 3, 1),     Vec3(0, 4, 1),  Vec3(-2, 3, 1),
                         Vec3(-4, 2, 1),    Vec3(-2, 1, 1), Vec3(0, -1, 1)};

/// Polygons with few and with many corners, the last of them with vertex normals.
Geometry polygons() {
    Geometry g;
    g.add(Polygon{many_digits}, 0);
    g.add(Polygon{star}, 0);
    g.add(Polygon{few_digits, many_digits}, 0);
    return g;
}

/// Checks that the derived data of every polygon match its current corners.
void check_kept(const Geometry& g) {
    for (const StoredPolygon& p : g.all<Polygon>()) {
        const PolygonFacts expected(p.corners);
        CHECK(p.facts.plane.mean == expected.plane.mean);
        CHECK(p.facts.plane.normal == expected.plane.normal);
        CHECK(p.facts.plane.error == expected.plane.error);
        CHECK(p.facts.box == expected.box);
        const OutlineProjection &projection = p.facts.projection, &other = expected.projection;
        CHECK(projection.along == other.along);
        CHECK(projection.scale == other.scale);
        CHECK(projection.off_plane == other.off_plane);
        const std::size_t count = p.corners.size();
        for (std::size_t i = 0; p.columns.edges != 0 && i <= p.columns.edges; ++i) {
            const Vec3& corner = p.corners[i == 0 || i > count ? count - 1 : i - 1];
            const Vec3 in_box = corner - expected.box.min;
            CHECK(p.columns.x[i] == in_box[other.x_axis()] * other.scale.x);
            CHECK(p.columns.y[i] == in_box[other.y_axis()] * other.scale.y);
        }
    }
}

}  // namespace

TEST_CASE("TriangleList: given numbers near and far from each other, then all are kept") {
    Random random(1, 0);
    TriangleList list;
    std::vector<TriangleIndices> expected;
    for (int i = 0; i < 5000; ++i) {
        const std::size_t range = i < 1000 || i > 3000 ? 65'536 : std::size_t{1} << 32;
        TriangleIndices t;
        for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random.index(range));
        list.push_back(t);
        expected.push_back(t);
    }
    REQUIRE(list.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(list[i] == expected[i]);
}

TEST_CASE("Geometry: given corners of few and of many digits, then all are kept to the bit") {
    const Geometry g = mixture();
    CHECK(g.decimal_vertices.size() == 4);  // one of the vertices has few digits
    CHECK(corners(g, 0) == few_digits);
    CHECK(corners(g, 1) == few_digits);
    CHECK(corners(g, 2) == many_digits);
    CHECK(corners(g, 3) == many_digits);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(normal(g, 1, k) == Vec3(0, 0, 1));
        CHECK(normal(g, 3, k) == Vec3(0, 1, 0));
    }
}

TEST_CASE("Geometry: given another one appended, then its shapes are unchanged") {
    Geometry g = mixture();
    append(g, mixture());
    REQUIRE(g.primitives.size() == 12);
    for (const std::size_t first : {0U, 6U}) {
        CHECK(corners(g, first) == few_digits);
        CHECK(corners(g, first + 3) == many_digits);
        CHECK(normal(g, first + 3, 2) == Vec3(0, 1, 0));
        CHECK(g.get<Sphere>(g.primitives[first + 4]).radius == 4);
        CHECK(std::ranges::equal(g.get<Polygon>(g.primitives[first + 5]).corners, few_digits));
        CHECK(g.primitives[first + 5].material == 1);
    }
}

TEST_CASE("Geometry: given that it is moved, then every corner is, and normals stay") {
    const Vec3 offset(0.1, third, -5);
    const std::optional<Geometry> g = moved(mixture(), offset);
    REQUIRE(g);
    for (const std::size_t primitive : {0U, 1U}) {
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(corners(*g, primitive)[k] == few_digits[k] + offset);
        }
    }
    CHECK(normal(*g, 3, 0) == Vec3(0, 1, 0));
    CHECK(g->get<Sphere>(g->primitives[4]).centre == Vec3(1, 2, 3) + offset);
    CHECK_FALSE(moved(*moved(mixture(), Vec3(1.5e308)), Vec3(1.5e308)));
}

TEST_CASE("Polygon: given corners, then their mean, normal and box are kept") {
    const std::array square = {Vec3(1, 1, 5), Vec3(3, 1, 5), Vec3(3, 3, 5), Vec3(1, 3, 5)};
    Geometry g;
    g.add(Polygon{square}, 0);
    const PolygonFacts& facts = g.all<Polygon>()[0].facts;
    CHECK(facts.plane.mean == Vec3(1, 1, 0));
    CHECK(facts.plane.normal == Vec3(0, 0, 8));
    CHECK(facts.box == Box3(Vec3(1, 1, 5), Vec3(3, 3, 5)));
    CHECK(facts.projection.along == 2);
    CHECK(facts.projection.scale == Vec2(0.5));
    CHECK(facts.projection.off_plane < 1e-13);
    g.add(Polygon{std::array{Vec3(0), Vec3(1), Vec3(2), Vec3(1)}}, 0);
    CHECK(g.all<Polygon>()[1].facts.box.isEmpty());
}

TEST_CASE("Polygon: given others appended, then each has its own corners, normals and plane") {
    Geometry g = polygons();
    append(g, polygons());
    append(g, *moved(polygons(), Vec3(7)));
    REQUIRE(g.all<Polygon>().size() == 9);
    check_kept(g);
    for (const std::size_t first : {0U, 3U}) {
        CHECK(std::ranges::equal(g.all<Polygon>()[first + 1].corners, star));
        CHECK(g.all<Polygon>()[first + 1].columns.edges >= star.size());
        CHECK(g.all<Polygon>()[first + 1].normals.empty());
        CHECK(std::ranges::equal(g.all<Polygon>()[first + 2].corners, few_digits));
        CHECK(std::ranges::equal(g.all<Polygon>()[first + 2].normals, many_digits));
    }
    CHECK(g.all<Polygon>()[7].corners[0] == star[0] + Vec3(7));
}

TEST_CASE("Polygon: given that it is moved or enlarged, then its derived data follow") {
    const Vec3 offset(0.1, third, -5);
    Scene scene;
    scene.geometry = polygons();
    const Geometry far = *moved(scene.geometry, offset);
    const Geometry large = transformed(scene, 3, offset).geometry;
    check_kept(far);
    check_kept(large);
    for (std::size_t k = 0; k < star.size(); ++k) {
        CHECK(far.all<Polygon>()[1].corners[k] == star[k] + offset);
        CHECK(large.all<Polygon>()[1].corners[k] == 3.0 * star[k] + offset);
    }
    CHECK(std::ranges::equal(far.all<Polygon>()[2].normals, many_digits));
}
