#include "core/texture/mapping.h"

#include "tests/catch.h"

using namespace etalon;

namespace {

void check_coordinates(const Mapping& mapping, const TexturePoint& point, const Vec2& expected) {
    const Vec2 st = texture_coordinates(mapping, point);
    INFO(st.x << " " << st.y << " for " << expected.x << " " << expected.y);
    CHECK(std::abs(st.x - expected.x) < 1e-12);
    CHECK(std::abs(st.y - expected.y) < 1e-12);
}

/// Maps the point (1, 2, 3) to the origin and permutes the axes x, y, z to y, z, x.
const Affine turned{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {-3, -1, -2}};

}  // namespace

TEST_CASE("a uv mapping scales the surface's coordinates and then moves them", "[texture]") {
    check_coordinates(UvMapping{}, {{0.25, 0.75}, {9, 9, 9}}, {0.25, 0.75});
    check_coordinates(UvMapping{2, -4, 0.5F, 0.125F}, {{0.25, 0.75}, {}}, {1, -2.875});
}

TEST_CASE("a spherical mapping is the angle from z and the one about it", "[texture]") {
    const SphericalMapping plain{};
    check_coordinates(plain, {{}, {0, 0, 2}}, {0, 0});
    check_coordinates(plain, {{}, {3, 0, 0}}, {0.5, 0});
    check_coordinates(plain, {{}, {0, 3, 0}}, {0.5, 0.25});
    check_coordinates(plain, {{}, {0, -1, -1}}, {0.75, 0.75});
    check_coordinates(plain, {{}, {0, 0, 0}}, {0, 0});
    check_coordinates(SphericalMapping{turned}, {{}, {1, 2, 8}}, {0.5, 0});
    check_coordinates(SphericalMapping{turned}, {{}, {4, 2, 3}}, {0.5, 0.25});
}

TEST_CASE("a cylindrical mapping is the angle about z, from -x, and z on the unit sphere",
          "[texture]") {
    const CylindricalMapping plain{};
    check_coordinates(plain, {{}, {2, 0, 0}}, {0.5, 0});
    check_coordinates(plain, {{}, {0, -2, 0}}, {0.25, 0});
    check_coordinates(plain, {{}, {0, 3, 4}}, {0.75, 0.8});
    check_coordinates(plain, {{}, {0, 0, 0}}, {0.5, 1});
    check_coordinates(CylindricalMapping{turned}, {{}, {1, 7, 3}}, {0.5, 1});
}

TEST_CASE("a planar mapping is the point along two axes, moved", "[texture]") {
    check_coordinates(PlanarMapping{}, {{9, 9}, {1, 2, 3}}, {1, 2});
    check_coordinates(PlanarMapping{{0, 0, 2}, {1, 1, 0}, 0.5F, -1}, {{}, {1, 2, 3}}, {6.5, 2});
}
