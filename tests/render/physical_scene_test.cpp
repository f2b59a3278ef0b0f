// Scenes of the Whitted-style formats converted to physical materials and lights.
#include <filesystem>

#include "core/color/srgb.h"
#include "core/convert/physical_material.h"
#include "core/convert/physical_scene.h"
#include "core/formats/load.h"
#include "core/formats/write/write.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinRel;

namespace {

namespace fs = std::filesystem;

TestScene loaded(LoadResult result) {
    REQUIRE(result.scene);
    TestScene scene;
    static_cast<Scene&>(scene) = std::move(*result.scene);
    scene.settings = result.settings;
    return scene;
}

/// A scene of P3F statements with a narrow camera at (0, 0, 5) that looks at the origin.
TestScene p3f_scene(const std::string& statements, int samples = 64) {
    return loaded(load_scene_text("p3f\nspp " + std::to_string(samples) + "\n" + statements +
                                      "camera\neye 0 0 5\nat 0 0 0\nup 0 1 0\nangle 1\n"
                                      "hither 0.01\nresolution 8 8\naperture 0\nfocal 1\n",
                                  "a.p3f"));
}

Color mean(const std::vector<Color>& pixels) {
    Color sum(0.0F);
    for (const Color& c : pixels) sum += c;
    return sum / static_cast<float>(pixels.size());
}

Color mean(TestScene scene, const char* integrator) {
    scene.settings.integrator = integrator;
    return mean(image(scene));
}

/// Returns the green radiance of a scene rendered with `whitted`.
double whitted_light(const TestScene& scene) {
    return srgb_decoded(mean(scene, "whitted").y);
}

/// Largest difference between a decoded product and the product of its decoded factors, here.
constexpr double decoding_error = 0.15;

/// Converts a material whose colours are light.
template <class Kind>
Kind made_of(const Material& material) {
    std::vector<PhysicalMaterial> list;
    const std::uint32_t number = add_physical(material, LightValues(false), list);
    REQUIRE(number == list.size() - 1);
    const Kind* const kind = std::get_if<Kind>(&list[number].kind);
    REQUIRE(kind);
    return *kind;
}

const std::string floor_of_half =
    "mat 1 0.5 0.25 0.8 1 1 1 0 10 0 1\np 4\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\n";

}  // namespace

TEST_CASE("A diffuse surface that faces a light is as bright by path as by whitted", "[path]") {
    for (const std::string light :
         {"l 0 0 3 1 1 1\n", "l 0 0 3 0.5 0.5 0.5\n", "l 0 0 40 0.7 0.8 0.9\n",
          "light quad 0.45 -0.05 3 1 1 1 0.55 -0.05 3 0.45 0.05 3 4\n",
          "light quad 0.45 -0.05 3 1 1 1 0.55 -0.05 3 0.45 0.05 3.1 4\n"}) {
        CAPTURE(light);
        const TestScene scene = p3f_scene(light + floor_of_half);
        CHECK_THAT(mean(scene, "path").y, WithinRel(whitted_light(scene), decoding_error));
    }
}

TEST_CASE("Mirrors and glass look the same with path and whitted", "[path]") {
    const std::string sky = "bclr 0.8 0.6 0.4\n";
    const std::string ball = "s 0 0 0 1\n";
    for (const std::string& material : {std::string("mat 0 0 0 0 1 0.5 1 0.7 10 0 1\n"),
                                        std::string("mat 0 0 0 0 1 1 1 0 10 1 1.5\n")}) {
        CAPTURE(material);
        // Absorption is lost, and an `f` has none.
        const std::string statement = material.substr(3);
        const TestScene scene = p3f_scene(sky + "f" + statement + ball);
        CHECK_THAT(mean(scene, "path").y, WithinRel(whitted_light(scene), decoding_error));
    }
}

TEST_CASE("A highlight's microfacets are as wide as docs/physical.md says", "[path]") {
    const auto alpha = [](Highlight highlight, double exponent) {
        Material m;
        m.diffuse = m.specular = Color(0.25F);
        m.highlight = highlight;
        m.shininess = exponent;
        const Roughness r = made_of<UberMaterial>(m).roughness;
        CHECK(r.u.value == r.v.value);
        CHECK_FALSE(r.remap);
        return r.u.value;
    };
    CHECK_THAT(alpha(Highlight::blinn, 6), WithinRel(0.5F, 1e-6F));  // sqrt(2 / 8)
    CHECK_THAT(alpha(Highlight::blinn, 48), WithinRel(0.2F, 1e-6F));
    CHECK_THAT(alpha(Highlight::phong, 1.5), WithinRel(0.5F, 1e-6F));
    CHECK_THAT(alpha(Highlight::phong, 12), WithinRel(0.2F, 1e-6F));
    CHECK(alpha(Highlight::blinn, 0) == 1);
    CHECK(alpha(Highlight::blinn, -5) == 1);
    CHECK(alpha(Highlight::blinn, 1e12) == 0.001F);
}

TEST_CASE("Weights are divided by their sum where it exceeds 1, a highlight's by 0.09", "[path]") {
    Material m;
    m.diffuse = Color(1.0F, 0.5F, 0.5F);
    m.specular = Color(1.0F, 1.0F, 0.5F);
    const auto shiny = made_of<UberMaterial>(m);
    CHECK_THAT(shiny.kd.value.x, WithinRel(1 / 1.09F, 1e-6F));
    CHECK_THAT(shiny.ks.value.x, WithinRel(1 / 1.09F, 1e-6F));
    CHECK(shiny.kd.value.y == 0.5F);
    CHECK(shiny.ks.value.y == 1);
    CHECK(shiny.ks.value.z == 0.5F);
    CHECK(shiny.eta.value == 1.5F);
    // Mirrored light is not transmitted, too.
    m = Material{};
    m.diffuse = Color(0.5F);
    m.reflection = m.transmission = Color(0.75F);
    m.fresnel = true;
    m.ior = 1.25;
    const auto clear = made_of<UberMaterial>(m);
    CHECK_THAT(clear.kd.value.y, WithinRel(0.4F, 1e-6F));
    CHECK_THAT(clear.kr.value.y, WithinRel(0.6F, 1e-6F));
    CHECK_THAT(clear.kt.value.y, WithinRel(0.6F, 1e-6F));
    CHECK(clear.eta.value == 1.25F);
}

TEST_CASE("A material sends back no more light than it gets", "[path]") {
    const TestScene scene =
        p3f_scene("bclr 1 1 1\nmat 1 1 1 0.9 1 1 1 0.9 10 0 1\ns 0 0 0 1\n", 256);
    CHECK(mean(scene, "path").y < 1.02);
    CHECK(mean(scene, "path").y > 0.9);
}

TEST_CASE("Every scene of features renders by path, to finite pixels that are not black",
          "[path]") {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(ETALON_SOURCE_DIR "/scenes/features")) {
        if (entry.path().extension() != ".p3f") continue;
        CAPTURE(entry.path());
        TestScene scene = loaded(load_scene(entry.path().string()));
        find_integrator("path")->prepare_scene(scene, scene.settings);
        scene.settings.samples_per_pixel = 2;
        scene.settings.resolution = {32, 24};
        const std::vector<Color> pixels = image(scene);
        for (const Color& c : pixels) REQUIRE(is_finite(c));
        CHECK(mean(pixels).y > 0.01);
        ++count;
    }
    CHECK(count >= 15);
}

TEST_CASE("A scene that is converted to PBRT has the image that path gives of it", "[path]") {
    for (const char* name : {"lights", "mirrors", "glass", "glossy", "soft_shadows"}) {
        CAPTURE(name);
        TestScene scene =
            loaded(load_scene(ETALON_SOURCE_DIR "/scenes/features/" + std::string(name) + ".p3f"));
        scene.settings.resolution = {32, 24};
        const WrittenScene written = write_pbrt(scene, scene.settings, "");
        TestScene converted = loaded(load_scene_text(written.text, "a.pbrt", {}));
        find_integrator("path")->prepare_scene(scene, scene.settings);
        CHECK(converted.settings.integrator == "path");
        CHECK(converted.settings.samples_per_pixel == scene.settings.samples_per_pixel);
        CHECK(converted.settings.max_depth == scene.settings.max_depth);
        const std::vector<Color> own = image(scene), other = image(converted);
        for (int k = 0; k < 3; ++k) CHECK_THAT(mean(other)[k], WithinRel(mean(own)[k], 0.03F));
    }
}

TEST_CASE("A skybox lights a scene by path", "[path]") {
    TestScene scene = loaded(load_scene(ETALON_SOURCE_DIR "/scenes/features/skybox.p3f"));
    scene.settings.resolution = {32, 24};
    scene.settings.samples_per_pixel = 64;
    const std::vector<Color> as_seen = image(scene);
    scene.settings.integrator = "path";
    const std::vector<Color> as_light = image(scene);
    // The upper left corner shows the sky itself.
    CHECK_THAT(as_light[0].y, WithinRel(static_cast<float>(srgb_decoded(as_seen[0].y)), 0.02F));
}
