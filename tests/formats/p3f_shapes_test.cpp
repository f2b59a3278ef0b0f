// s, box, pl, npl and c.
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

struct OnlyObject {
    explicit OnlyObject(const std::string& text) : result(load_objects(text)) {
        CAPTURE(text);
        CHECK(messages(result).empty());
        REQUIRE(result.scene->geometry.primitives.size() == 1);
    }
    Sides sides() const { return result.scene->geometry.primitives[0].sides; }
    template <class Shape>
    const Shape& as() const {
        REQUIRE(result.scene->geometry.primitives[0].kind == kind_of<Shape>());
        return result.scene->geometry.get<Shape>(result.scene->geometry.primitives[0]);
    }
    LoadResult result;
};

/// Returns the message about an object that is left out, which must be at line 2, column 1.
std::string warning_of(const std::string& text) {
    const LoadResult r = load_objects(text + "\ns 0 0 0 1");
    CAPTURE(text);
    REQUIRE(r.diagnostics.size() == 1);
    CHECK(r.diagnostics[0].line == 2);
    CHECK(r.diagnostics[0].column == 1);
    CHECK(r.diagnostics[0].severity == Severity::warning);
    REQUIRE(r.scene);
    CHECK(r.scene->geometry.primitives.size() == 1);
    return r.diagnostics[0].message;
}

}  // namespace

TEST_CASE("a sphere is read") {
    const OnlyObject o("s 1 2 3 0.5");
    CHECK(o.as<Sphere>().centre == Vec3(1, 2, 3));
    CHECK(o.as<Sphere>().radius == 0.5);
    CHECK(o.sides() == Sides::both);
}

TEST_CASE("a sphere of negative radius shows only its inside") {
    const OnlyObject o("s 1 2 3 -0.5");
    CHECK(o.as<Sphere>().radius == 0.5);
    CHECK(o.sides() == Sides::back);
}

TEST_CASE("a sphere of radius 0 is left out") {
    CHECK(warning_of("s 1 2 3 0") == "'s' left out: its radius is 0");
}

TEST_CASE("a box is read") {
    const OnlyObject o("box -1 -2 -3 1 2 3");
    CHECK(o.as<Box>().min == Vec3(-1, -2, -3));
    CHECK(o.as<Box>().max == Vec3(1, 2, 3));
    CHECK(o.sides() == Sides::both);
    CHECK(OnlyObject("box 0 0 0 1 0 1").as<Box>().max == Vec3(1, 0, 1));
}

TEST_CASE("a box with its corners exchanged is put right") {
    const LoadResult r = load_objects("box 1 -2 3 -1 2 -3");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:1: warning: the corners of 'box' are not the lower and the upper "
                   "one; exchanged"});
    CHECK(r.scene->geometry.all<Box>()[0].min == Vec3(-1, -2, -3));
    CHECK(r.scene->geometry.all<Box>()[0].max == Vec3(1, 2, 3));
}

TEST_CASE("a box without area is left out") {
    CHECK(warning_of("box 0 0 0 1 0 0") == "'box' left out: it has no area");
}

TEST_CASE("a plane through three points faces where they run counter-clockwise") {
    const OnlyObject o("pl 12 12 -0.5 -12 12 -0.5 -12 -12 -0.5");
    const Plane& p = o.as<Plane>();
    CHECK(p.point == Vec3(12, 12, -0.5));
    CHECK(p.normal.x == 0);
    CHECK(p.normal.y == 0);
    CHECK(p.normal.z > 0);
}

TEST_CASE("a plane's normal does not depend on a power of two in the scene's scale") {
    const std::string points[] = {"0.1 0.2 0.3", "0.7 -0.2 0.9", "0.25 0.3 -0.35"};
    const auto normal = [&](double scale) {
        std::string text = "pl";
        for (const std::string& p : points) {
            for (std::size_t i = 0, end = 0; i < p.size(); i = end + 1) {
                end = std::min(p.find(' ', i), p.size());
                char number[64];
                std::snprintf(number, sizeof number, " %.17g",
                              scale * std::stod(p.substr(i, end - i)));
                text += number;
            }
        }
        return OnlyObject(text).as<Plane>().normal;
    };
    CHECK(normal(1) == normal(0x1p20));
    CHECK(normal(1) == normal(0x1p-20));
    CHECK(normal(1) == normal(0x1p-1000));
}

TEST_CASE("the square of a plane's normal is in the range of double") {
    for (const char* plane :
         {"pl 2.8 -.15 -1  -.74 -1e160 -.3  3 -.3 -.87", "pl 0 0 0 1 0 0 0 1 0"}) {
        const Vec3 n = OnlyObject(plane).as<Plane>().normal;
        CHECK(max_abs(n) >= 1);
        CHECK(max_abs(n) < 2);
    }
}

TEST_CASE("a plane whose points span none is left out") {
    CHECK(warning_of("pl 0 0 0 1 1 1 2 2 2") == "'pl' left out: its points span no plane");
    CHECK(warning_of("pl 1 1 1 1 1 1 2 5 2") == "'pl' left out: its points span no plane");
    CHECK(warning_of("pl 1e308 0 0 -1e308 0 0 0 1 0") == "'pl' left out: its points span no plane");
}

TEST_CASE("a plane in Hessian form holds the points with N.p + D = 0") {
    const OnlyObject o("npl 0 0 2 -6");
    const Plane& p = o.as<Plane>();
    CHECK(p.point == Vec3(0, 0, 3));
    CHECK(p.normal.x == 0);
    CHECK(p.normal.z > 0);
    const OnlyObject slanted("npl 1 2 2 9");
    const Plane& q = slanted.as<Plane>();
    CHECK(q.point.x == Approx(-1));
    CHECK(q.point.y == Approx(-2));
    CHECK(q.point.z == Approx(-2));
}

TEST_CASE("a plane in Hessian form that is none is left out") {
    CHECK(warning_of("npl 0 0 0 1") == "'npl' left out: its normal is zero");
    CHECK(warning_of("npl 1e-300 0 0 1e300") == "'npl' left out: its position is not finite");
}

TEST_CASE("a cone is two circles about an axis") {
    const OnlyObject o("c 1 2 3 0.5\n4 5 6 0.25");
    const Cone& c = o.as<Cone>();
    CHECK(c.base == Vec3(1, 2, 3));
    CHECK(c.top == Vec3(4, 5, 6));
    CHECK(c.base_radius == 0.5);
    CHECK(c.top_radius == 0.25);
    CHECK(o.sides() == Sides::both);
}

TEST_CASE("a cone of negative radii shows only its inside") {
    for (const std::string radii : {"-0.5 0 0 1 -0.25", "-0.5 0 0 1 0", "0 0 0 1 -0.5"}) {
        const OnlyObject o("c 0 0 0 " + radii);
        CHECK(o.sides() == Sides::back);
        CHECK(o.as<Cone>().base_radius >= 0);
        CHECK(o.as<Cone>().top_radius >= 0);
    }
    CHECK(OnlyObject("c 0 0 0 0 0 0 1 0.5").sides() == Sides::both);
}

TEST_CASE("a cone that cannot be seen is left out") {
    CHECK(warning_of("c 0 0 0 1 0 0 0 1") == "'c' left out: its base and its apex are one point");
    CHECK(warning_of("c 0 0 0 0 0 0 1 0") == "'c' left out: both its radii are 0");
    CHECK(warning_of("c 0 0 0 1 0 0 1 -1") == "'c' left out: only one of its radii is negative");
    CHECK(warning_of("c 0 0 0 -1 0 0 1 1") == "'c' left out: only one of its radii is negative");
}
