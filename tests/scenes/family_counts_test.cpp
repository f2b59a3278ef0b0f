#include <fmt/format.h>

#include "tests/catch.h"
#include "tests/scenes/generated_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

struct Counts {
    std::size_t spheres = 0, triangles = 0, polygons = 0, cones = 0;
    bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << fmt::format("{} spheres, {} triangles, {} polygons, {} cones", c.spheres,
                              c.triangles, c.polygons, c.cones);
}

Counts counts(const Scene& scene) {
    return {scene.geometry.all<Sphere>().size(), scene.geometry.all<Triangle>().size(),
            scene.geometry.all<Polygon>().size(), scene.geometry.all<Cone>().size()};
}

struct Expected {
    const char* family;
    std::int64_t size;
    Counts counts;
};

}  // namespace

TEST_CASE("A family's size gives the number of primitives it promises", "[scenes]") {
    // One polygon of each classic scene is its ground.
    const auto expected = GENERATE(values<Expected>({
        {"sphereflake", 0, {.spheres = 1, .polygons = 1}},
        {"sphereflake", 2, {.spheres = 1 + 9 + 81, .polygons = 1}},
        {"sphereflake", 4, {.spheres = 7381, .polygons = 1}},
        {"tetra", 0, {.triangles = 4, .polygons = 1}},
        {"tetra", 3, {.triangles = 4 * 4 * 4 * 4, .polygons = 1}},
        {"mountain", 0, {.spheres = 4, .triangles = 2, .polygons = 1}},
        {"mountain", 4, {.spheres = 4, .triangles = 2 * 256, .polygons = 1}},
        {"rings", 1, {.spheres = 30, .polygons = 1, .cones = 30}},
        {"rings", 7, {.spheres = 4200, .polygons = 1, .cones = 4200}},
        {"gears", 1, {.polygons = 1 + 2 + 144}},
        {"gears", 3, {.polygons = 1 + 27 * (2 + 144)}},
        {"tree", 0, {.spheres = 1, .polygons = 1, .cones = 1}},
        {"tree", 11, {.spheres = 4095, .polygons = 1, .cones = 4095}},
        {"soup", 1, {.triangles = 1}},
        {"soup", 5000, {.triangles = 5000}},
        {"spheres", 1, {.spheres = 1}},
        {"spheres", 5000, {.spheres = 5000}},
    }));
    INFO(expected.family << " " << expected.size);
    const Scene scene = family_scene(expected.family, expected.size);
    CHECK(counts(scene) == expected.counts);
    CHECK_FALSE(scene.whitted().lights.empty());
}

TEST_CASE("The faces of a gear are polygons of 144 corners", "[scenes]") {
    const Scene scene = family_scene("gears", 2);
    int large = 0;
    for (const Polygon& p : scene.geometry.all<Polygon>()) large += p.corners.size() == 144;
    CHECK(large == 2 * 8);
}

TEST_CASE("A size of a family of instances is their number", "[scenes]") {
    for (const auto& [family, objects] : {std::pair("forest", 20U), std::pair("plaza", 3U)}) {
        const Scene scene = family_scene(family, 70);
        CHECK(scene.geometry.instances.size() == 70);
        CHECK(scene.geometry.objects.size() == objects);
        CHECK(scene.geometry.primitives.size() == 2);
    }
    for (const Geometry& tree : family_scene("forest", 1).geometry.objects) {
        CHECK(tree.primitives.size() == 400);
    }
}

TEST_CASE("Instances of a plaza are of all sizes from 1e-4 to 1e4", "[scenes]") {
    std::array<int, 8> of_decade{};
    for (const Instance& i : family_scene("plaza", 800).geometry.instances) {
        const double decade = std::floor(std::log10(i.to_world().y.length()));
        REQUIRE(decade >= -4);
        REQUIRE(decade <= 3);
        ++of_decade[static_cast<std::size_t>(decade + 4)];
    }
    for (const int count : of_decade) CHECK(count > 60);
}
