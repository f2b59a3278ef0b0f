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
    g.add(Polygon{0, 3}, 1);
    return g;
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
    CHECK(g.decimal_vertices.size() == 4);  // one of the corners of many digits has few
    CHECK(corners(g, 0) == few_digits);
    CHECK(corners(g, 1) == few_digits);
    CHECK(corners(g, 2) == many_digits);
    CHECK(corners(g, 3) == many_digits);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(normal(g, 1, k) == Vec3(0, 0, 1));
        CHECK(normal(g, 3, k) == Vec3(0, 1, 0));
    }
}

TEST_CASE("Geometry: given another one appended, then its shapes are what they were") {
    Geometry g = mixture();
    append(g, mixture());
    REQUIRE(g.primitives.size() == 12);
    for (const std::size_t first : {0U, 6U}) {
        CHECK(corners(g, first) == few_digits);
        CHECK(corners(g, first + 3) == many_digits);
        CHECK(normal(g, first + 3, 2) == Vec3(0, 1, 0));
        CHECK(g.get<Sphere>(g.primitives[first + 4]).radius == 4);
        const auto& polygon = g.get<Polygon>(g.primitives[first + 5]);
        CHECK(g.vertices[polygon.first] == few_digits[0]);
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
