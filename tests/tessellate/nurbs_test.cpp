#include "core/tessellate/nurbs.h"

#include <cmath>

#include "core/tessellate/b_spline_basis.h"
#include "core/tessellate/grid_corners.h"
#include "tests/catch.h"

using namespace etalon;
using Catch::Matchers::WithinAbs;

namespace {

using Knots = std::vector<float>;

/// A quarter of a circle in x and y (order 3, the middle weight the cosine of 45 degrees) that
/// moves along z (order 2).
struct QuarterCylinder {
    Knots u_knots{0, 0, 0, 1, 1, 1}, v_knots{0, 0, 1, 1};
    std::vector<std::array<float, 4>> points;

    QuarterCylinder() {
        const auto w = static_cast<float>(std::sqrt(0.5));
        for (const float z : {0.0F, 2.0F}) {
            points.push_back({1, 0, z, 1});
            points.push_back({w, w, z * w, w});
            points.push_back({0, 1, z, 1});
        }
    }
    Nurbs surface(double u0 = 0, double u1 = 1) const {
        return {{3, 3, u_knots, u0, u1}, {2, 2, v_knots, 0, 1}, points};
    }
};

}  // namespace

TEST_CASE("basis functions of a B-spline add up to 1 and their derivatives to 0") {
    const Knots knots{0, 0, 0, 0, 1, 1.5F, 1.5F, 4, 7, 7, 7, 7};
    for (double t = 0; t <= 7; t += 0.03125) {
        const BSplineBasis b = b_spline_basis(knots, 4, t);
        REQUIRE(b.weights.size() == 4);
        CHECK(b.first + 4 <= 8);
        double sum = 0, slopes = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(b.weights[i] >= 0);
            sum += b.weights[i], slopes += b.derivatives[i];
        }
        CHECK_THAT(sum, WithinAbs(1, 1e-14));
        CHECK_THAT(slopes, WithinAbs(0, 1e-13));
    }
}

TEST_CASE("derivatives of a B-spline's basis are those of its values") {
    const Knots knots{-1, 0, 0.5F, 1, 2, 3, 3.5F, 5};
    constexpr double h = 0x1p-20;
    for (double t = 1.1; t < 1.9; t += 0.1) {
        const BSplineBasis before = b_spline_basis(knots, 4, t - h),
                           after = b_spline_basis(knots, 4, t + h),
                           at = b_spline_basis(knots, 4, t);
        REQUIRE(before.first == after.first);
        for (std::size_t i = 0; i < 4; ++i) {
            const double slope = (after.weights[i] - before.weights[i]) / (2 * h);
            CHECK_THAT(at.derivatives[i], WithinAbs(slope, 1e-8));
        }
    }
}

TEST_CASE("a rational surface is a cylinder, with its normals and coordinates") {
    const QuarterCylinder quarter;
    CHECK(nurbs_error(quarter.surface()).empty());
    const NurbsGrid grid = diced(quarter.surface(), 30);
    REQUIRE(grid.points.size() == 900);
    for (std::size_t i = 0; i < 900; ++i) {
        const Vec3 &p = grid.points[i], &n = grid.normals[i];
        CHECK_THAT(std::hypot(p.x, p.y), WithinAbs(1, 1e-7));
        CHECK_THAT(n.x, WithinAbs(p.x, 1e-6));
        CHECK_THAT(n.y, WithinAbs(p.y, 1e-6));
        CHECK_THAT(n.z, WithinAbs(0, 1e-6));
        CHECK_THAT(p.z, WithinAbs(2 * static_cast<double>(i / 30) / 29, 1e-6));
        CHECK_THAT(grid.uvs[i][0], WithinAbs(static_cast<double>(i % 30) / 29, 1e-6));
        CHECK_THAT(grid.uvs[i][1], WithinAbs(static_cast<double>(i / 30) / 29, 1e-6));
    }
    CHECK(grid.points[0] == Vec3(1, 0, 0));
    CHECK(grid.points[899] == Vec3(0, 1, 2));
}

TEST_CASE("a part of a surface begins and ends where it is said to") {
    const QuarterCylinder quarter;
    const NurbsGrid whole = diced(quarter.surface(), 5),
                    part = diced(quarter.surface(0.25, 0.5), 2);
    CHECK((part.points[0] - whole.points[1]).length() < 1e-15);
    CHECK((part.points[1] - whole.points[2]).length() < 1e-15);
}

TEST_CASE("a surface that shrinks to a point has no normal there") {
    QuarterCylinder cone;
    for (std::size_t i = 3; i < 6; ++i) {
        const float w = cone.points[i][3];
        cone.points[i] = {0, 0, 2 * w, w};
    }
    const NurbsGrid grid = diced(cone.surface(), 4);
    CHECK(grid.points[15] == Vec3(0, 0, 2));
    CHECK(grid.normals[15] == Vec3(0));
    CHECK_THAT(grid.normals[0].length(), WithinAbs(1, 1e-12));
}

TEST_CASE("surfaces whose numbers do not go together are refused") {
    const QuarterCylinder good;
    const auto error = [](const Nurbs& surface) { return nurbs_error(surface); };
    Nurbs bad = good.surface();
    bad.u.order = 1;
    CHECK(error(bad) == "along u: its order is 2 or more, not 1");
    bad = good.surface();
    bad.v.order = 3;
    CHECK(error(bad) == "along v: a spline of order 3 has 3 points or more, not 2");
    bad = good.surface();
    bad.u.knots = bad.u.knots.first(5);
    CHECK(error(bad) == "along u: 3 points of order 3 have 6 knots, not 5");
    const Knots falling{0, 0, 1, 0}, flat{1, 1, 1, 1};
    bad = good.surface();
    bad.v.knots = falling;
    CHECK(error(bad) == "along v: its knots decrease");
    bad.v.knots = flat;
    CHECK(error(bad) == "along v: its knots are all in one place");
    CHECK(error(good.surface(0, 1.5)) == "along u: its part from 0 to 1.5 is not within 0 to 1");
    bad = good.surface();
    bad.points = bad.points.first(5);
    CHECK(error(bad) == "3 x 2 control points are 6, not 5");
}

TEST_CASE("a grid's cells are two triangles each, which turn from columns to rows") {
    CHECK(grid_corners(2, 2) == std::vector<std::uint32_t>{0, 1, 3, 0, 3, 2});
    CHECK(grid_corners(4, 3).size() == 36);
    CHECK(grid_corners(4, 3).back() == 10);
    CHECK(grid_corners(1, 9).empty());
    CHECK(grid_corners(9, 0).empty());
}
