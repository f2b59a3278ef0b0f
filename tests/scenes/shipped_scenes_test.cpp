#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/formats/load.h"
#include "tests/catch.h"

using namespace etalon;
namespace fs = std::filesystem;

namespace {

const std::string folder = ETALON_SOURCE_DIR "/scenes";

/// The words that begin a line of the file, and for lights also the kind.
std::set<std::string> keywords(const std::string& path) {
    std::set<std::string> result;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string first;
        std::string second;
        words >> first >> second;
        result.insert(first == "light" ? first + " " + second : first);
    }
    return result;
}

/// Returns whether some corners of the polygon turn one way and some the other.
bool is_concave(const Polygon& p) {
    const auto corner = [&](std::size_t k) { return p.corners[k % p.corners.size()]; };
    const auto turn = [&](std::size_t k) {
        return (corner(k + 1) - corner(k)) % (corner(k + 2) - corner(k + 1));
    };
    for (std::size_t k = 1; k < p.corners.size(); ++k) {
        if (turn(0).dot(turn(k)) < 0) return true;
    }
    return false;
}

bool has(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.geometry.primitives.list(), [&](const Primitive& p) {
        return condition(p, scene.whitted().materials[p.material]);
    });
}

}  // namespace

TEST_CASE("Every shipped scene loads strictly, without a diagnostic", "[scenes]") {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".p3f" && extension != ".pbrt") continue;
        INFO(entry.path());
        LoadOptions options;
        options.strict = true;
        const auto result = load_scene(entry.path(), options);
        CHECK(report(result.diagnostics) == "");
        CHECK(result.scene.has_value());
        ++count;
    }
    CHECK(count >= 24);
}

TEST_CASE("The showcase uses every statement of P3F", "[scenes]") {
    const auto words = keywords(folder + "/showcase.p3f");
    for (const char* word : {"accel", "spp", "bclr", "env", "camera", "light punctual",
                             "light quad", "mat", "s", "box", "pl", "p", "pp", "mesh", "c"}) {
        INFO(word);
        CHECK(words.contains(word));
    }
}

TEST_CASE("The showcase uses all variants of P3F's statements", "[scenes]") {
    const auto result = load_scene(folder + "/showcase.p3f");
    REQUIRE(result.scene.has_value());
    const Scene& scene = *result.scene;
    const Color none(0.0F);

    CHECK(scene.camera.aperture > 0);
    CHECK(result.settings.samples_per_pixel > 0);
    CHECK(scene.whitted().environment.skybox.has_value());

    CHECK(
        has(scene, [&](auto, auto& m) { return m.reflection == none && m.transmission == none; }));
    CHECK(
        has(scene, [&](auto, auto& m) { return m.reflection != none && m.transmission == none; }));
    CHECK(has(scene, [&](auto, auto& m) { return m.absorption != none; }));

    const auto sphere = kind_of<Sphere>();
    const auto cone = kind_of<Cone>();
    CHECK(has(scene, [&](auto& p, auto) { return p.kind == sphere && p.sides == Sides::both; }));
    CHECK(has(scene, [&](auto& p, auto) { return p.kind == sphere && p.sides == Sides::back; }));
    CHECK(has(scene, [&](auto& p, auto) { return p.kind == cone && p.sides == Sides::both; }));

    const auto& cones = scene.geometry.all<Cone>();
    const auto is_cylinder = [](const Cone& c) { return c.base_radius == c.top_radius; };
    CHECK(std::ranges::any_of(cones, is_cylinder));
    CHECK_FALSE(std::ranges::all_of(cones, is_cylinder));
    bool has_concave = false;
    for (const Polygon& p : scene.geometry.all<Polygon>()) has_concave |= is_concave(p);
    CHECK(has_concave);
}
