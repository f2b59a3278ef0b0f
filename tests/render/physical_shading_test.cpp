#include "core/shading/physical_shading.h"

#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns normals for shading where some rays hit a ball of this material.
std::vector<Vec3> normals_of(const std::string& material) {
    const TestScene scene = pbrt_scene(
        "Texture \"waves\" \"float\" \"fbm\"\n"
        "Texture \"lower\" \"float\" \"scale\" \"texture tex1\" \"waves\" \"float tex2\" 0.25\n"
        "Texture \"turned\" \"float\" \"scale\" \"texture tex1\" \"lower\" \"float tex2\" -1\n" +
        material + " Shape \"sphere\"");
    std::vector<std::string> problems;
    const PhysicalShading shading(scene, problems);
    std::vector<Vec3> normals;
    for (int i = 0; i < 25; ++i) {
        const Ray ray{Vec3(0.3 * (i % 5) - 0.55, 0.3 * (i / 5) - 0.65, -5), Vec3(0, 0, 1)};
        const auto hit = find_backend(reference_backend)->build(scene.geometry)->closest(ray);
        REQUIRE(hit);
        LazyStorage<LobeList> room;
        normals.push_back(shading.scattering(physical_surface(scene, ray, *hit), room).frame.ns);
    }
    return normals;
}

}  // namespace

TEST_CASE("Bump map: given an even material, then its normals are turned", "[shading]") {
    const std::vector<Vec3> even = normals_of("Material \"matte\""),
                            bumpy = normals_of("Material \"matte\" \"texture bumpmap\" \"lower\"");
    for (std::size_t i = 0; i < even.size(); ++i) CHECK((even[i] - bumpy[i]).length() > 1e-4);
}

TEST_CASE("Bump map: given a reversed surface, then it is displaced to the other side",
          "[shading]") {
    const std::vector<Vec3> inwards = normals_of(
                                "ReverseOrientation Material \"matte\" \"texture bumpmap\" "
                                "\"turned\""),
                            outwards =
                                normals_of("Material \"matte\" \"texture bumpmap\" \"lower\"");
    for (std::size_t i = 0; i < inwards.size(); ++i) {
        CHECK((inwards[i] + outwards[i]).length() < 1e-6);
    }
}
