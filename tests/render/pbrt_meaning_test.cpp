// What statements of PBRT mean where pbrt-v3's source decides it, by small scenes whose images are
// known.
#include <fmt/format.h>

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

/// Returns the material of a statement, which is of that kind.
template <class Kind>
Kind material_of(const std::string& statement) {
    const TestScene scene = pbrt_scene("Material " + statement + " Shape \"sphere\"");
    const Kind* const kind = std::get_if<Kind>(&scene.physical().materials.back().kind);
    REQUIRE(kind);
    return *kind;
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

TEST_CASE("A crop window's borders in pixels are rounded up", "[pbrt]") {
    const auto window = [](const std::string& crop) {
        return pbrt_scene("",
                          "Film \"image\" \"integer xresolution\" 10 \"integer yresolution\" 10 "
                          "\"float cropwindow\" [" +
                              crop + "]")
            .settings.window();
    };
    // 3.3 to 6.6 of x, 2.1 to 7.5 of y.
    CHECK(window(".33 .66 .21 .75") == Imath::Box2i({4, 3}, {6, 7}));
    CHECK(window(".66 .33 .75 .21") == window(".33 .66 .21 .75"));
    CHECK(window("-1 .5 .5 2") == Imath::Box2i({0, 5}, {4, 9}));
}

TEST_CASE("A filter has the two widths and the shape that are given", "[pbrt]") {
    const auto filter = [](const std::string& statement) {
        return pbrt_scene("", "PixelFilter " + statement).settings.filter;
    };
    const std::string widths = " \"float xwidth\" 1.5 \"float ywidth\" 2.5 ";
    for (const FilterType& type : filter_list) {
        INFO(type.name);
        const PixelFilter f = filter(fmt::format("\"{}\"{}", type.name, widths));
        CHECK(f.kind == type.kind);
        CHECK(f.radius == Vec2(1.5, 2.5));
    }
    const PixelFilter mitchell = filter("\"mitchell\" \"float B\" .25 \"float C\" .75");
    CHECK(mitchell.b == 0.25);
    CHECK(mitchell.c == 0.75);
    CHECK(filter("\"gaussian\" \"float alpha\" .5").alpha == 0.5);
    CHECK(filter("\"sinc\" \"float tau\" 2.5").tau == 2.5);
}

TEST_CASE("A camera shows the angle and the window that are given", "[pbrt]") {
    const auto camera = [](const std::string& parameters) {
        return *pbrt_scene("", "Camera \"perspective\" " + parameters).camera.projective;
    };
    // tan(20 degrees), of the half of the shorter side.
    CHECK_THAT(camera("\"float fov\" 40").half_side, WithinRel(0.36397023, 1e-7));
    CHECK_THAT(camera("\"float fov\" 90 \"float halffov\" 20").half_side,
               WithinRel(0.36397023, 1e-7));
    const ProjectiveCamera lens = camera("\"float lensradius\" .5 \"float focaldistance\" 4");
    CHECK(lens.lens_radius == 0.5);
    CHECK(lens.focal_distance == 4);
    const auto is = [&](const std::string& parameters, double left, double right, double bottom,
                        double top) {
        INFO(parameters);
        const std::optional<ImageWindow> window =
            camera("\"float fov\" 90 " + parameters).fixed_window;
        REQUIRE(window);
        CHECK_THAT(window->left, WithinRel(left, 1e-7));
        CHECK_THAT(window->right, WithinRel(right, 1e-7));
        CHECK_THAT(window->bottom, WithinRel(bottom, 1e-7));
        CHECK_THAT(window->top, WithinRel(top, 1e-7));
    };
    is("\"float screenwindow\" [-1 3 -2 .5]", -1, 3, -2, 0.5);
    is("\"float frameaspectratio\" 2", -2, 2, -1, 1);
    is("\"float frameaspectratio\" .5", -1, 1, -2, 2);
}

TEST_CASE("Each colour and number of a material is the one of its name", "[pbrt]") {
    const std::string base = "\"rgb Kd\" [.1 .2 .3] \"rgb Ks\" [.4 .5 .6] ",
                      through = "\"rgb Kr\" [.2 .3 .4] \"rgb Kt\" [.5 .6 .7] ",
                      rough =
                          "\"float uroughness\" .25 \"float vroughness\" .5 "
                          "\"bool remaproughness\" \"false\" ";
    const auto is = [](const ColorSlot& slot, float x, float y, float z) {
        return slot.texture == no_index && slot.value == Color(x, y, z);
    };
    const auto check_base = [&](const auto& m) {
        CHECK(is(m.kd, 0.1F, 0.2F, 0.3F));
        CHECK(is(m.ks, 0.4F, 0.5F, 0.6F));
    };
    const auto check_through = [&](const auto& m) {
        CHECK(is(m.kr, 0.2F, 0.3F, 0.4F));
        CHECK(is(m.kt, 0.5F, 0.6F, 0.7F));
        CHECK(m.eta.value == 1.25F);
    };
    const auto check_rough = [](const Roughness& r) {
        CHECK(r.u.value == 0.25F);
        CHECK(r.v.value == 0.5F);
        CHECK_FALSE(r.remap);
    };
    const auto plastic =
        material_of<PlasticMaterial>("\"plastic\" \"float roughness\" .25 " + base);
    check_base(plastic);
    CHECK(plastic.roughness.u.value == 0.25F);
    CHECK(plastic.roughness.v.value == 0.25F);
    CHECK(plastic.roughness.remap);
    const auto leaf = material_of<TranslucentMaterial>(
        "\"translucent\" " + base + "\"rgb reflect\" [.2 .3 .4] \"rgb transmit\" [.5 .6 .7]");
    check_base(leaf);
    CHECK(is(leaf.reflect, 0.2F, 0.3F, 0.4F));
    CHECK(is(leaf.transmit, 0.5F, 0.6F, 0.7F));
    const auto glass =
        material_of<GlassMaterial>("\"glass\" \"float eta\" 1.25 " + through + rough);
    check_through(glass);
    check_rough(glass.roughness);
    const auto metal = material_of<MetalMaterial>(
        "\"metal\" \"rgb eta\" [.2 .3 .4] \"rgb k\" [.5 .6 .7] " + rough);
    CHECK(is(metal.eta, 0.2F, 0.3F, 0.4F));
    CHECK(is(metal.k, 0.5F, 0.6F, 0.7F));
    check_rough(metal.roughness);
    const auto coated = material_of<SubstrateMaterial>("\"substrate\" " + base + rough);
    check_base(coated);
    check_rough(coated.roughness);
    const auto uber = material_of<UberMaterial>("\"uber\" \"float eta\" 1.25 " + base + through +
                                                "\"rgb opacity\" [.7 .8 .9] " + rough);
    check_base(uber);
    check_through(uber);
    check_rough(uber.roughness);
    CHECK(is(uber.opacity, 0.7F, 0.8F, 0.9F));
}

TEST_CASE("What a light's picture shows turns with the light", "[pbrt]") {
    const auto light = [](const std::string& statement) {
        return pbrt_scene("AttributeBegin Translate 1 2 3 Rotate 90 1 0 0 LightSource " +
                          statement + " AttributeEnd")
            .physical()
            .lights.at(0);
    };
    // The light's y is the world's z, its z the world's -y.
    const auto is_turned = [](const Affine& to_light) {
        return (to_light.vector({0, 0, 1}) - Vec3(0, 1, 0)).length() < 1e-6 &&
               (to_light.vector({0, -1, 0}) - Vec3(0, 0, 1)).length() < 1e-6;
    };
    const std::string scale = " \"rgb scale\" [2 3 4]";
    const auto sky_light =
        std::get<InfiniteSource>(light("\"infinite\" \"rgb L\" [1 2 3]" + scale));
    CHECK(is_turned(sky_light.to_light));
    CHECK(sky_light.radiance == Color(2, 6, 12));
    const auto lamp =
        std::get<GoniometricSource>(light("\"goniometric\" \"rgb I\" [1 2 3]" + scale));
    CHECK(is_turned(lamp.to_light));
    CHECK(lamp.position == Vec3(1, 2, 3));
    CHECK(lamp.intensity == Color(2, 6, 12));
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
