// Curves of PBRT converted to segments of Bezier curves.
#include "core/formats/load.h"
#include "core/scene/bezier.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;

namespace {

LoadResult loaded(const std::string& parameters) {
    LoadResult r = load_scene_text(
        "WorldBegin\nTranslate 0 0 5 Shape \"curve\" " + parameters + "\nWorldEnd\n", "a.pbrt", {});
    REQUIRE(r.scene);
    return r;
}

std::vector<Curve> curves(const std::string& parameters) {
    const LoadResult r = loaded(parameters);
    CHECK(r.diagnostics.empty());
    std::vector<Curve> list;
    for (const StoredCurve& c : r.scene->geometry.all<Curve>()) list.emplace_back(c);
    return list;
}

bool is_close(const Vec3f& a, const Vec3f& b) {
    return (a - b).length() < 1e-6F;
}

Vec3 point_at(const BezierCurve& c, double u) {
    return blossom({Vec3(c.points[0]), Vec3(c.points[1]), Vec3(c.points[2]), Vec3(c.points[3])}, u,
                   u, u);
}

const std::string cubic = "\"point P\" [0 0 0  1 2 0  2 -2 0  3 0 1] ";

}  // namespace

TEST_CASE("a curve is eight parts where its split depth is not given") {
    const std::vector<Curve> list = curves(cubic + "\"float width0\" 2 \"float width1\" 1");
    REQUIRE(list.size() == 8);
    for (std::uint32_t i = 0; i < 8; ++i) {
        CHECK(list[i].part.number == i);
        CHECK(list[i].part.count == 8);
        CHECK(list[i].curve == list[0].curve);
    }
    CHECK(list[0].curve.points[1] == Vec3f(1, 2, 0));
    CHECK(list[0].curve.widths == std::array{2.0F, 1.0F});
    CHECK(list[0].curve.type == CurveType::flat);
    CHECK(list[0].to_world.origin == Vec3(0, 0, 5));
    CHECK(curves(cubic + "\"integer splitdepth\" 0").size() == 1);
    CHECK(curves(cubic + "\"integer splitdepth\" 30").size() == CurveList::most_parts);
}

TEST_CASE("a quadratic curve is the cubic one of the same points") {
    const BezierCurve c = curves("\"integer degree\" 2 \"point P\" [0 0 0  1 2 0  3 0 0]")[0].curve;
    CHECK(is_close(c.points[1], Vec3f(2.0F / 3, 4.0F / 3, 0)));
    CHECK((point_at(c, 0.5) - Vec3(1.25, 1, 0)).length() < 1e-6);
}

TEST_CASE("pieces of a curve follow each other, with widths and normals of their own") {
    const std::vector<Curve> list = curves(
        "\"string type\" \"ribbon\" \"integer splitdepth\" 0 \"float width0\" 1 \"float width1\" 3 "
        "\"integer degree\" 2 \"point P\" [0 0 0  1 1 0  2 0 0  3 -1 0  4 0 0] "
        "\"normal N\" [0 0 2  0 3 0  1 0 0]");
    REQUIRE(list.size() == 2);
    CHECK(list[0].curve.points[3] == list[1].curve.points[0]);
    CHECK(list[0].curve.widths == std::array{1.0F, 2.0F});
    CHECK(list[1].curve.widths == std::array{2.0F, 3.0F});
    CHECK(list[0].curve.normals[0] == Vec3f(0, 0, 1));
    CHECK(list[1].curve.normals[0] == Vec3f(0, 1, 0));
    CHECK(list[1].curve.normals[1] == Vec3f(1, 0, 0));
}

TEST_CASE("a B-spline of even steps on a line moves evenly") {
    for (const char* degree : {"2", "3"}) {
        const std::vector<Curve> list =
            curves("\"string basis\" \"bspline\" \"integer splitdepth\" 0 \"integer degree\" " +
                   std::string(degree) + " \"point P\" [0 0 0  1 0 0  2 0 0  3 0 0  4 0 0]");
        REQUIRE(list.size() == (degree[0] == '2' ? 3 : 2));
        const double first = degree[0] == '2' ? 0.5 : 1;
        for (std::size_t i = 0; i < list.size(); ++i) {
            for (const double u : {0.0, 0.25, 1.0}) {
                const double x = first + static_cast<double>(i) + u;
                CHECK((point_at(list[i].curve, u) - Vec3(x, 0, 0)).length() < 1e-6);
            }
        }
    }
}

TEST_CASE("a curve without a width is left out") {
    const LoadResult r = loaded(cubic + "\"float width\" 0");
    REQUIRE(r.diagnostics.size() == 1);
    CHECK(to_string(r.diagnostics[0]) ==
          "a.pbrt:2:17: warning: \"curve\" left out: it has no width");
    CHECK(r.scene->geometry.item_count() == 0);
}
