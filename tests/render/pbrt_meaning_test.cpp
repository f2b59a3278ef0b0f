// What statements of PBRT mean where pbrt-v3's source decides it, by small scenes whose images are
// known.
#include <numbers>

#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double brightness(const std::string& world, const std::string& options = "") {
    double sum = 0;
    const std::vector<Color> pixels = image(pbrt_scene(world, options));
    for (const Color& c : pixels) sum += c.y;
    return sum / static_cast<double>(pixels.size());
}

const std::string sky = "LightSource \"infinite\" \"color L\" [1 1 1]\n";
const std::string narrow = "Camera \"perspective\" \"float fov\" .01\n";

/// A square at z = 0 that faces the camera.
const std::string square =
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
    "\"point P\" [-9 -9 0 9 -9 0 9 9 0 -9 9 0]\n";

/// What a point light of intensity 10 at the position gives the middle of the square.
double lit_by(const Vec3& at) {
    return 0.5 / std::numbers::pi * 10 * std::abs(at.z) / std::pow(at.length(), 3);
}

}  // namespace

TEST_CASE("A point light is its `from` away from where the origin is", "[pbrt]") {
    const std::string light = "LightSource \"point\" \"color I\" [10 10 10] \"point from\" ";
    const auto lit = [&](const std::string& moved) {
        return brightness("TransformBegin " + moved + " TransformEnd\n" + square, narrow);
    };
    CHECK_THAT(lit("Rotate 90 0 1 0 Scale 2 1 1 " + light + "[1 2 -3]"),
               WithinRel(lit_by({1, 2, -3}), 1e-4));
    CHECK_THAT(lit("Translate 0 1 -1 " + light + "[1 1 -2]"), WithinRel(lit_by({1, 2, -3}), 1e-4));
}

TEST_CASE("Integrators of direct light end with the last lit surface", "[pbrt]") {
    const std::string mirror = sky + "Material \"mirror\" \"color Kr\" [.5 .5 .5]\n" + square;
    const std::string matte = sky + "Material \"matte\" \"color Kd\" [.5 .5 .5]\n" + square;
    for (const std::string name : {"directlighting", "whitted"}) {
        INFO(name);
        const auto depth = [&](int most) {
            return fmt::format("Integrator \"{}\" \"integer maxdepth\" {}", name, most);
        };
        CHECK(brightness(mirror, depth(1)) == 0);
        CHECK_THAT(brightness(mirror, depth(2)), WithinRel(0.5, 1e-6));
        CHECK_THAT(brightness(matte, depth(0)), WithinRel(0.5, 1e-4));
        CHECK_THAT(brightness(matte, depth(1)), WithinRel(0.5, 1e-4));
    }
}

TEST_CASE("A light that no ray can hit lights as much as one that is seen", "[pbrt]") {
    const std::string lamp =
        "AttributeBegin AreaLightSource \"diffuse\" \"color L\" [4 4 4] \"bool twosided\" "
        "\"true\"\n"
        "Translate 1 0 -.5 Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
        "\"point P\" [-.9 -1 0 1 -1 0 1 1 0 -.9 1 0]\n";
    const std::string seen = square + lamp + " AttributeEnd",
                      unseen = square + lamp + "\"float alpha\" 0 AttributeEnd";
    for (const std::string name : {"path", "volpath", "directlighting"}) {
        INFO(name);
        const std::string options = narrow + "Sampler \"sobol\" \"integer pixelsamples\" 1024\n" +
                                    "Integrator \"" + name + "\" \"integer maxdepth\" 1";
        CHECK_THAT(brightness(unseen, options), WithinRel(brightness(seen, options), 5e-3));
    }
}

TEST_CASE("An uber material without a roughness along v has that along u", "[pbrt]") {
    const auto shining = [](const std::string& roughness) {
        return brightness(
            "LightSource \"distant\" \"point from\" [1 0 -2] \"point to\" [0 0 0]\n"
            "Material \"uber\" \"color Kd\" [0 0 0] \"color Ks\" [1 1 1]" +
            roughness + " Shape \"sphere\"");
    };
    const double both = shining("\"float uroughness\" .5 \"float vroughness\" .5");
    CHECK(both > 0);
    CHECK(shining("\"float uroughness\" .5") == both);
    CHECK(shining("\"float vroughness\" .5 \"float roughness\" .5") == both);
    CHECK(shining("\"float vroughness\" .5") != both);
}

TEST_CASE("Normals at corners are interpolated with their lengths", "[pbrt]") {
    const auto lit = [](const std::string& normals) {
        return brightness(
            "LightSource \"distant\" \"point from\" [0 0 -1] \"point to\" [0 0 0]\n"
            "Material \"matte\" \"color Kd\" [.5 .5 .5]\n" +
                square + "\"normal N\" [" + normals + "]",
            narrow);
    };
    // In the middle of the diagonal the normal is in the direction of the sum of two.
    const double most = 0.5 / std::numbers::pi;
    CHECK_THAT(lit("0 0 -10  1 0 0  1 0 0  0 0 -10"), WithinRel(most * 10 / std::sqrt(101), 1e-3));
    CHECK_THAT(lit("0 0 -1  1 0 0  1 0 0  0 0 -1"), WithinRel(most / std::sqrt(2), 1e-3));
    CHECK_THAT(lit("0 0 -1e-3  0 0 -1e9  0 0 -1  0 0 -2"), WithinAbs(most, 1e-6));
}

TEST_CASE("Pixel bounds may have their least number last", "[pbrt]") {
    const auto window = [](const std::string& bounds) {
        return pbrt_scene("", "Integrator \"path\" \"integer pixelbounds\" [" + bounds + "]")
            .settings.window();
    };
    CHECK(window("2 6 1 5") == Imath::Box2i({2, 1}, {5, 4}));
    CHECK(window("6 2 5 1") == window("2 6 1 5"));
}

TEST_CASE("Paths of most vertices end at a surface without a material", "[pbrt]") {
    const std::string bubble = sky + "Material \"none\" Shape \"sphere\"";
    const auto seen = [&](const std::string& name, int most) {
        return brightness(bubble,
                          fmt::format("Integrator \"{}\" \"integer maxdepth\" {}", name, most));
    };
    for (const std::string name : {"path", "volpath"}) {
        INFO(name);
        CHECK(seen(name, 0) == 0);
        CHECK_THAT(seen(name, 1), WithinRel(1, 1e-6));
    }
    CHECK_THAT(seen("directlighting", 0), WithinRel(1, 1e-6));
}

TEST_CASE("Scattering by the two normals of a mesh is that of pbrt-v3", "[pbrt]") {
    const std::string options =
        "Camera \"perspective\" \"float fov\" 30 PixelFilter \"box\"\n"
        "Sampler \"sobol\" \"integer pixelsamples\" 1024\n";
    const std::string octahedron =
        "Shape \"trianglemesh\" \"integer indices\"\n"
        "[0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5] \"point P\"\n"
        "[1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1] \"normal N\"\n"
        "[1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1]\n";
    const std::string leaf =
        "LightSource \"point\" \"color I\" [12 12 12] \"point from\" [1 3 -1.5]\n"
        "Material \"translucent\" \"color Kd\" [1 1 1] \"color Ks\" [0 0 0]\n";
    const std::string wax =
        sky + "Material \"subsurface\" \"color sigma_a\" [.3 .3 .3] \"color sigma_s\" [8 8 8]\n";
    // The means of pbrt-v3's images.
    CHECK_THAT(brightness(leaf + octahedron, options), WithinRel(0.0250, 0.01));
    CHECK_THAT(brightness(wax + octahedron, options), WithinRel(0.8938, 2e-3));
}

TEST_CASE("Anisotropic reflections of a mesh whose coordinates are all the same are pbrt-v3's",
          "[pbrt]") {
    const std::string mesh =
        "LightSource \"point\" \"color I\" [9 9 9] \"point from\" [2 1 -3]\n"
        "Material \"substrate\" \"color Kd\" [0 0 0] \"float uroughness\" .1 \"float vroughness\" "
        ".6\n"
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"float uv\" [0 0 0 0 0 0 0 0]\n"
        "\"point P\" [-1 -1 -.2 1 -1 .1 1 1 .3 -1 1 0]\n";
    CHECK_THAT(brightness(mesh, "PixelFilter \"box\""), WithinRel(0.036768, 1e-4));
}
