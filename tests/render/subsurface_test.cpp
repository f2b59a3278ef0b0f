// Subsurface scattering.
#include <fmt/format.h>

#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

Color mean_of(const TestScene& scene) {
    Color sum(0);
    const std::vector<Color>& pixels = rendered(scene).film.pixels();
    for (const Color& c : pixels) sum += c / static_cast<float>(pixels.size());
    return sum;
}

/// A square at a depth behind the origin, seen from the front or the back.
std::string square(double z, bool faces_camera, double half = 20) {
    return fmt::format(
        "Shape \"trianglemesh\" \"integer indices\" [{}] \"point P\" "
        "[-{h} -{h} {z} {h} -{h} {z} {h} {h} {z} -{h} {h} {z}]\n",
        faces_camera ? "0 2 1 0 3 2" : "0 1 2 0 2 3", fmt::arg("h", half), fmt::arg("z", z));
}

const std::string everywhere = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n";
const std::string from_behind =
    "LightSource \"distant\" \"rgb L\" [5 5 5] \"point from\" [0 0 1] \"point to\" [0 0 0]\n";
const std::string wax =
    "Material \"kdsubsurface\" \"rgb Kd\" [.8 .5 .2] \"rgb mfp\" [.1 .2 .1] \"rgb Kr\" [0 0 0]\n";
const std::string other_wax =
    "Material \"kdsubsurface\" \"rgb Kd\" [.8 .5 .3] \"rgb mfp\" [.1 .2 .1] \"rgb Kr\" [0 0 0]\n";

/// Limits paths to so many scattering vertices.
std::string depth(int vertices) {
    return "Integrator \"path\" \"integer maxdepth\" " + std::to_string(vertices);
}

}  // namespace

TEST_CASE("A body under uniform light has the requested colour", "[subsurface]") {
    const float reflected = 0.02006F;  // at an interface of relative index 1.33
    const Color wanted(0.8F, 0.5F, 0.2F);
    const Color seen = mean_of(pbrt_scene(everywhere + wax + square(0, true)));
    const Color disney = mean_of(pbrt_scene(
        everywhere +
        "Material \"disney\" \"rgb color\" [.8 .5 .2] \"rgb scatterdistance\" [.5 .4 .3] \"float "
        "eta\" 1 \"float roughness\" 0\n" +
        square(0, true)));
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(seen[c] == Approx((1 - reflected) * wanted[c]).epsilon(0.01));
        CHECK(disney[c] == Approx(wanted[c]).epsilon(0.02));
    }
}

TEST_CASE("Light comes through to surfaces of the same material", "[subsurface]") {
    const std::string front = from_behind + wax + square(0, true);
    const Color through = mean_of(pbrt_scene(front + square(0.1, false)));
    CHECK(through.y > 0.01F);
    CHECK(through.y > through.z);
    CHECK(mean_of(pbrt_scene(front + other_wax + square(0.1, false))) == Color(0.0F));
    // Surfaces of other materials in between have no effect on probes.
    const Color past = mean_of(pbrt_scene(front + square(0.1, false) + "Material \"matte\"\n" +
                                          square(0.03, true) + square(0.05, false)));
    CHECK(past.y == Approx(through.y).epsilon(0.02));
    // No light passes through objects thicker than the probes' length.
    CHECK(mean_of(pbrt_scene(front + square(30, false))) == Color(0.0F));
}

TEST_CASE("Every surface on a probe may be the one where light comes in", "[subsurface]") {
    // Nearly coincident squares, of which light reaches only the first.
    const std::string one = everywhere + wax + square(0, true), once = depth(1);
    const Color alone = mean_of(pbrt_scene(one, once));
    const Color three = mean_of(pbrt_scene(one + square(1e-4, true) + square(2e-4, true), once));
    CHECK(three.y == Approx(alone.y).epsilon(0.03));
}

TEST_CASE("Light below surfaces is that of path in volpath", "[subsurface]") {
    const std::string world = everywhere + wax + "Shape \"sphere\"\n";
    const std::string with_medium =
        "MakeNamedMedium \"air\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0 0 0] \"rgb "
        "sigma_s\" [0 0 0]\n" +
        world;
    const TestScene path = pbrt_scene(world);
    const TestScene volpath = pbrt_scene(world, "Integrator \"volpath\"");
    const TestScene in_air = pbrt_scene(with_medium, "Integrator \"volpath\"");
    CHECK(rendered(path).film.pixels() == rendered(volpath).film.pixels());
    CHECK(mean_of(in_air).y == Approx(mean_of(path).y).epsilon(0.02));
}

TEST_CASE("A path of one vertex sees light from below, and none of no vertex", "[subsurface]") {
    const std::string world = from_behind + wax + square(0, true) + square(0.1, false);
    CHECK(mean_of(pbrt_scene(world, depth(0))) == Color(0.0F));
    CHECK(mean_of(pbrt_scene(world, depth(1))).y > 0.01F);
}
