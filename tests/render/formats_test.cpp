// Images of files of NFF and PRT.
#include <cmath>
#include <functional>
#include <numbers>

#include "core/formats/write/write.h"
#include "tests/catch.h"
#include "tests/formats/messages.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

TestScene scene_of(const std::string& format, const std::string& text) {
    LoadResult r = load_text(format, text);
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    return {std::move(*r.scene), r.settings};
}

/// Returns the colour seen from (x, y, 5) along -z, with a background of (0.25, 0.5, 1).
Color nff_at(double x, double y, const std::string& text) {
    const std::string place = std::to_string(x) + " " + std::to_string(y);
    return centre(scene_of("nff", "b 0.25 0.5 1 v from " + place + " 5 at " + place +
                                      " 0 up 0 1 0 angle 9 hither 0 resolution 1 1\n" + text));
}

Color prt_at(double x, double y, const std::string& text) {
    const std::string place = std::to_string(x) + " " + std::to_string(y);
    return centre(scene_of("prt", "from " + place + " 5 at " + place +
                                      " 0 up 0 1 0 angle 9 resolution 1 1 background .25 .5 1 n\n" +
                                      text));
}

const Color background(0.25F, 0.5F, 1.0F);
const std::string glowing = "surface 0 0 0 0 0 0 0 0 1 0 0 0 0 0 0 0 0 0 0\n";
const Color glow(1.0F, 0.0F, 0.0F);

std::string clear(const std::string& ior) {
    return "surface 0 0 0 0 1 1 1 1 0 0 0 0 0 0 0 0 0 0 " + ior + "\n";
}

}  // namespace

TEST_CASE("NFF glass lets a part of the light through", "[render]") {
    const Color seen = nff_at(0, 0, "f 1 1 1 0 0 100000 0.5 1\ns 0 0 0 1\n");
    CHECK(seen.x == Approx(0.25 * 0.25));
    CHECK(seen.z == Approx(1 * 0.25));
}

TEST_CASE("a matt NFF surface of any Shine has no highlight", "[render]") {
    const std::string lamp = "l 0 0 9\n", ball = "s 0 0 0 1\n";
    const Color seen = nff_at(0, 0, lamp + "f 0.5 1 0 0.5 0 100000 0 0\n" + ball);
    CHECK(seen.x == Approx(0.25));
    CHECK(seen.y == Approx(0.5));
    CHECK(seen == nff_at(0, 0, lamp + "f 0.5 1 0 0.5 0 0 0 0\n" + ball));
}

TEST_CASE("an NFF highlight is where the reflected ray goes", "[render]") {
    const auto seen_from = [](const std::string& eye) {
        return centre(scene_of("nff", "v from " + eye +
                                          " at 0 0 0 up 0 1 0 angle 9 hither 0 "
                                          "resolution 1 1 l -2 0 2 f 1 1 1 0 0.5 40 0 0\n"
                                          "p 4 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n"));
    };
    CHECK(seen_from("1 0 1").x == Approx(0.5));
    CHECK(seen_from("-1 0 1").x == Approx(0).margin(1e-6));
}

TEST_CASE("a concave NFF polygon of 144 corners has its teeth and its notches", "[render]") {
    const double step = std::numbers::pi / 72;
    std::string gear = "l 0 0 9\nf 1 1 1 1 0 1 0 0\np 144\n";
    for (int i = 0; i < 144; ++i) {
        const double radius = i % 2 == 0 ? 1 : 0.5;
        gear += std::to_string(radius * std::cos(i * step)) + " " +
                std::to_string(radius * std::sin(i * step)) + " 0\n";
    }
    for (const int i : {0, 1, 34, 71, 100, 143}) {
        const Color seen = nff_at(0.75 * std::cos(i * step), 0.75 * std::sin(i * step), gear);
        CHECK((seen == background) == (i % 2 == 1));
    }
}

TEST_CASE("a PRT shell of index 1 is not seen", "[render]") {
    const std::string wall = glowing + "polygon 4 -9 -9 -4 0 -9 -4 0 9 -4 -9 9 -4\n";
    for (const double x : {-0.9, -0.6, -0.2, 0.1, 0.55, 0.95}) {
        const Color seen = prt_at(x, 0.1, wall + clear("1") + "hsphere 0 0 0 1 .25\n");
        CHECK(seen == (x < 0 ? glow : background));
    }
}

TEST_CASE("a thin PRT shell of glass does not invert the image as a ball does", "[render]") {
    const std::string wall = glowing + "polygon 4 -99 -99 -40 0 -99 -40 0 99 -40 -99 99 -40\n";
    for (const double x : {-0.5, 0.5}) {
        const bool left = x < 0;
        CHECK(prt_at(x, 0, wall + clear("1.5") + "hsphere 0 0 0 1 .001\n") ==
              (left ? glow : background));
        CHECK(prt_at(x, 0, wall + clear("1.5") + "sphere 0 0 0 1\n") == (left ? background : glow));
        CHECK(prt_at(x, 0, wall + clear("1.5") + "hsphere 0 0 0 1 1\n") ==
              (left ? background : glow));
    }
}

TEST_CASE("a PRT ring is matter between its two radii", "[render]") {
    const std::string ring = glowing + "ring 0 0 0 1 0 0 0 1 0 2 1\n";
    CHECK(prt_at(0.5, 0, ring) == background);
    CHECK(prt_at(0, 1.5, ring) == glow);
    CHECK(prt_at(2.5, 0, ring) == background);
}

TEST_CASE("mixed and linear coefficients of a PRT quadric are doubled", "[render]") {
    const auto quadric = [](const std::string& coefficients) {
        return glowing + "quadric 0 0 0 -9 -9 -9 9 9 9 " + coefficients + "\n";
    };
    // x^2 + y^2 + z^2 - 2x = 0: the unit sphere about (1, 0, 0).
    const std::string shifted = quadric("1 0 0 -1 1 0 0 1 0 0");
    CHECK(prt_at(1.9, 0, shifted) == glow);
    CHECK(prt_at(-0.1, 0, shifted) == background);
    // x^2 + y^2 + z^2 + xy - 1 = 0, b being half: it ends at (1, -1) and at (0.577, 0.577).
    const std::string tilted = quadric("1 .5 0 0 1 0 0 1 0 -1");
    CHECK(prt_at(0.95, -0.95, tilted) == glow);
    CHECK(prt_at(1.05, -1.05, tilted) == background);
    CHECK(prt_at(0.55, 0.55, tilted) == glow);
    CHECK(prt_at(0.65, 0.65, tilted) == background);
}

TEST_CASE("a PRT quadric is cut to its box, and its farther root tried", "[render]") {
    const std::string unit = "1 0 0 0 1 0 0 1 0 -1\n";
    CHECK(prt_at(0, 0, glowing + "quadric 0 0 0 -1 -1 -1 1 1 0 " + unit) == glow);
    CHECK(prt_at(0.5, 0, glowing + "quadric 0 0 0 -1 -1 -1 0 1 1 " + unit) == background);
}

TEST_CASE("PRT's ambient colour is added as it is", "[render]") {
    const Color seen = prt_at(
        0, 0, "light 0 0 9\nsurface 0 0 0 0 0 0 0 0 .5 0 0 .25 .5 0 0 0 0 0 0\nsphere 0 0 0 1\n");
    CHECK(seen.x == Approx(0.75));
    CHECK(seen.y == Approx(0.5));
}

namespace {

/// A hall of pairs of a ring and a glass ball over a floor; each pair is written by `pair`.
TestScene hall_of_pairs(const std::string& definition,
                        const std::function<std::string(double, double)>& pair) {
    std::string text = "from 1 4 9 at 1 0 0 up 0 1 0 angle 40 resolution 40 30 light 3 9 9\n";
    text += "background .25 .5 1 n\n" + definition +
            "surface 0 0 0 0 0 0 0 0 .1 0 0 .5 .7 .2 0 0 0 1 1\n";
    text += "polygon 4 -9 -1 -9 -9 -1 9 9 -1 9 9 -1 -9\n";
    for (const double x : {-1.5, 0.25, 2.0}) text += pair(x, 0.5 * x);
    return scene_of("prt", text);
}

/// Returns the pair with its centre at x, y, 0. The ring has the surface of the statement before
/// it.
std::string pair_at(double x, double y) {
    const auto point = [&](double dx, double dy, double dz) {
        return std::to_string(x + dx) + ' ' + std::to_string(y + dy) + ' ' + std::to_string(dz) +
               ' ';
    };
    return "ring " + point(0, 0, 1) + point(1, 0, 1) + point(0, 1, 1) + "1 .5\n" + clear("1.5") +
           "sphere " + point(0, 0, 0) + ".5\n";
}

}  // namespace

TEST_CASE("PRT instances give the same image as copies, also when converted", "[render]") {
    const TestScene instances =
        hall_of_pairs("instance pair\n" + pair_at(0, 0) + "end_instance\n", [](double x, double y) {
            return "instance_of pair " + std::to_string(x) + ' ' + std::to_string(y) + " 0\n";
        });
    const TestScene copies = hall_of_pairs("", pair_at);
    REQUIRE(instances.geometry.objects.size() == 2);  // one of the floor's surface, one of glass
    REQUIRE(instances.geometry.instances.size() == 3);
    REQUIRE(copies.geometry.primitives.size() == 7);
    for (const std::string_view backend : {"none", "grid", "bvh", "embree"}) {
        CHECK(image(instances, backend) == image(copies, backend));
    }
    for (const SceneWriter write : {write_p3f, write_pbrt}) {
        const auto shown = [&](const TestScene& scene) {
            const WrittenScene written = write(scene, scene.settings, "");
            const LoadResult r = load_scene_text(
                written.text, "a." + std::string(written.format == "P3F" ? "p3f" : "pbrt"), {});
            REQUIRE(r.scene);
            return image({*r.scene, r.settings});
        };
        const std::vector<Color> a = shown(instances), b = shown(copies);
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (int k = 0; k < 3; ++k) CHECK(a[i][k] == Approx(b[i][k]).margin(1e-3));
        }
    }
}
