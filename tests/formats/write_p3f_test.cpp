// Scenes written as P3F, and read again.
#include <filesystem>

#include <fmt/core.h>

#include "core/formats/write/exact_endpoint.h"
#include "core/formats/write/p3f_material.h"
#include "core/formats/write/write.h"
#include "core/numerics/random.h"
#include "core/numerics/transforms.h"
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/same_scene.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

std::string text_of(const LoadResult& r) {
    return write_p3f(*r.scene, r.settings, "").text;
}

std::vector<std::string> lost(const LoadResult& r) {
    std::vector<std::string> list;
    for (const ConversionWarning& warning : write_p3f(*r.scene, r.settings, "").lost) {
        list.push_back(warning.what + " " + std::to_string(warning.count));
    }
    return list;
}

/// Reads, writes and reads again, twice, and requires the same scene without warnings.
void check_round_trip(const LoadResult& first, const std::string& path) {
    CAPTURE(path);
    REQUIRE(first.scene);
    const WrittenScene written =
        write_p3f(*first.scene, first.settings, fs::path(path).parent_path());
    CHECK(written.lost.empty());
    LoadOptions options;
    options.format = "p3f";
    const LoadResult again = load_scene_text(written.text, path, options);
    CHECK(messages(again).empty());
    REQUIRE(again.scene);
    CHECK(difference(first, again) == "");
    CHECK(write_p3f(*again.scene, again.settings, fs::path(path).parent_path()).text ==
          written.text);
}

/// Returns a number as in typical files, sometimes with all its digits.
double some_number(Random& random) {
    const auto digits = static_cast<double>(random.index(2001)) - 1000;
    return random.index(4) == 0 ? random.uniform(-10, 10) : digits / 100;
}

Vec3 some_point(Random& random) {
    return {some_number(random), some_number(random), some_number(random)};
}

Color some_color(Random& random) {
    const auto part = [&] { return static_cast<float>(random.index(201)) / 100; };
    return random.index(8) == 0 ? Color(0.0F) : Color(part(), part(), part() / 2);
}

}  // namespace

TEST_CASE("every statement of P3F is written as it was read") {
    const std::string text =
        "accel grid\nspp 4\nbclr 0.1 0.25 1\ncamera\neye 0 0.1 5\nat 0 0 -1e-20\nup 0 1 0\n"
        "angle 45\nhither 0\nresolution 40 30\naperture 2\nfocal 1.5\n"
        "light punctual 1 2 3 0.8 0.5 1\nlight quad 4 3 2 1 1 1 4 2 2 3 3 2 16\n"
        "mat 0.5 0.25 0.1 1 0.5 0.5 0.5 1 30 0 1\ns 0 0 0 1\ns 0 0 0 -1\n"
        "box 0 0 0 1 2 3\nc 0 0 0 1 0 2 0 0.5\nc 0 0 0 -1 0 2 0 -0.5\n"
        "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
        "mesh 3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n"
        "pp 3\n0 0 0 0 0 1\n1 0 0 1 0 0\n0 1 0 0 0 1\n"
        "pp 4\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n"
        "f 0.5 0.25 0.1 1 1 1 1 0.5 30 1 1.5\nmesh 4 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n1 3 4\n"
        "mat 0 0 0 1 1 1 1 0 30 0 1\nmesh 3 1\n0 0 2\n1 0 2\n0 1 2\n1 2 3\n"
        "mat 0.5 0.25 0.125 0 1 1 1 0.5 30 1 1.5\npl 0 0 1 1 0 1 0 1 1\n";
    const LoadResult r = load_p3f_text(text);
    CHECK(messages(r).empty());
    CHECK(text_of(r) == text);
}

TEST_CASE("a scene of every feature is the same when it is written and read again") {
    for (const auto& entry : fs::directory_iterator(ETALON_SOURCE_DIR "/scenes/features")) {
        if (entry.path().extension() != ".p3f") continue;
        check_round_trip(load_scene(entry.path().string()), entry.path().string());
    }
    const std::string showcase = ETALON_SOURCE_DIR "/scenes/showcase.p3f";
    check_round_trip(load_scene(showcase), showcase);
}

TEST_CASE("objects of all kinds with all their digits are the same when written and read again") {
    Random random(21);
    const auto numbers = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += fmt::format(" {}", some_number(random));
        return text + "\n";
    };
    for (int i = 0; i < 300; ++i) {
        std::string text = "light quad" + numbers(3) + " 1 1 1" + numbers(6) + " 9\n";
        text += "mat 1 1 1 1 1 1 1 0 1 0 1\ns" + numbers(3) + "1\npl" + numbers(9) + "npl" +
                numbers(4) + "box" + numbers(6) + "c" + numbers(3) + "1" + numbers(3) + "0\n";
        text += "pp 3" + numbers(18) + "mesh 3 1" + numbers(9) + "1 2 3\np 3" + numbers(9);
        LoadResult r = load_statements(text);
        r.diagnostics.clear();
        check_round_trip(r, "a.p3f");
    }
}

TEST_CASE("every material that P3F can express is read back") {
    Random random(22);
    const auto weight = [&] { return static_cast<double>(random.index(101)) / 100; };
    for (int i = 0; i < 100000; ++i) {
        const P3fMaterial n{some_color(random), random.index(4) == 0 ? 0 : weight(),
                            some_color(random), random.index(4) == 0 ? 0 : weight(),
                            weight() * 100,     random.index(2) == 0 ? 1.0 : 0.0,
                            0.5 + weight()};
        const bool absorbs = random.index(4) != 0;
        const Material m = to_material(n, absorbs);
        ConversionWarnings warnings;
        const P3fStatement s = to_p3f(m, warnings);
        const Material again = to_material(s.numbers, s.absorbs);
        CAPTURE(n.diffuse, n.kd, n.specular, n.ks, n.transmission, absorbs);
        REQUIRE(warnings.take().empty());
        REQUIRE(again.diffuse == m.diffuse);
        REQUIRE(again.specular == m.specular);
        REQUIRE(again.reflection == m.reflection);
        REQUIRE(again.absorption == m.absorption);
        REQUIRE(again.fresnel == m.fresnel);
    }
}

TEST_CASE("a highlight without a mirror is P3F's by a negative weight") {
    Material m;
    m.specular = Color(0.5F, 0.25F, 1);
    m.shininess = 9;
    ConversionWarnings warnings;
    const Material again = to_material(to_p3f(m, warnings).numbers, true);
    CHECK(warnings.take().empty());
    CHECK(again.specular == m.specular);
    CHECK(again.reflection == Color(0.0F));
}

TEST_CASE("the end of an edge is found where there is one") {
    Random random(23);
    for (int i = 0; i < 100000; ++i) {
        const Vec3 start = some_point(random), end = some_point(random);
        const ExactEndpoint found = exact_endpoint(start, end - start);
        REQUIRE(found.exact);
        REQUIRE(found.point - start == end - start);
    }
    CHECK_FALSE(exact_endpoint(Vec3(1e20, 0, 0), Vec3(1, 0, 0)).exact);
}

TEST_CASE("a plane is found again by three points, its normal up to a power of two") {
    Random random(24);
    int inexact = 0;
    for (int i = 0; i < 20000; ++i) {
        Plane plane{some_point(random), some_point(random) * std::ldexp(1.0, i % 100 - 50)};
        if (i % 7 == 0) plane.normal[i % 3] = 0;
        if (i % 5 == 0) plane.normal[i % 3] *= 1e-17;
        if (i % 11 == 0) plane.point = Vec3(0);
        if (plane.normal == Vec3(0)) continue;
        if (!points_on(plane).exact) ++inexact;
    }
    CHECK(inexact == 0);
}

TEST_CASE("features that P3F cannot express are listed, each kind once") {
    LoadResult r = load_objects("s 0 0 0 1\ns 1 0 0 1\n");
    Scene& s = *r.scene;
    CHECK(lost(r).empty());
    s.whitted().materials.push_back(s.whitted().materials[0]);
    std::vector<Primitive> primitives = s.geometry.primitives.list();
    primitives[1].material = 1;
    primitives[0].sides = Sides::front;
    s.geometry.primitives = PrimitiveRuns(primitives);
    for (Material& m : s.whitted().materials) m.ambient = Color(0.1F);
    s.whitted().materials[0].reflection = Color(0.5F);
    r.settings.max_depth = 7;
    r.settings.display_colors = false;
    CHECK(lost(r) ==
          std::vector<std::string>{"depth of 7 rays, now 5 1", "sRGB curve of a PNG 1",
                                   "ambient colour of a material 2",
                                   "highlight of another weight than the reflected ray 1",
                                   "shape seen from its front only 1"});
}

TEST_CASE("the stretched pixels of a PRT camera are listed unless they are square all the same") {
    const auto lost_at = [](const std::string& resolution) {
        return lost(load_text("prt", "from 0 0 5 at 0 0 0 up 0 1 0 angle 40 resolution " +
                                         resolution + "\nlight 0 9 9\n"));
    };
    CHECK(lost_at("40 40").empty());
    CHECK(lost_at("40 30") == std::vector<std::string>{"pixels that are not square 1"});
}

TEST_CASE("ellipsoids and closed cylinders become polygons on their surface, facing out") {
    const Affine map = translation({1, 2, 3}) * rotation(30, {1, 2, 3}) * scaling({1, -2, 3});
    LoadResult r = load_objects("s 0 0 0 1\n");
    Scene& scene = *r.scene;
    scene.geometry.primitives = {};
    scene.geometry.add(Ellipsoid(map), 0);
    scene.geometry.add(ClosedCylinder(map), 0);
    CHECK(lost(r) ==
          std::vector<std::string>{"ellipsoid, now polygons 1", "closed cylinder, now polygons 1"});
    const LoadResult read = load_p3f_text(write_p3f(scene, r.settings, "").text);
    CHECK(messages(read).empty());
    REQUIRE(read.scene->geometry.primitives.size() == 24 * 48 + 48 + 2);
    const LocalFrame& frame = scene.geometry.all<Ellipsoid>()[0].frame;
    const auto local = [&](const Vec3& p) { return frame.vector(p - map.origin); };
    constexpr std::size_t on_sphere = 22 * 48;  // and 2 * 48 triangles at the poles
    const auto& polygons = read.scene->geometry.all<Polygon>();
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::span<const Vec3> corners = polygons[i].corners;
        const Vec3 a = local(corners[0]), b = local(corners[1]), c = local(corners[2]);
        const double level = i < on_sphere ? a.z : 0;
        CHECK(a.x * a.x + a.y * a.y + level * level == Approx(1).epsilon(1e-12));
        const Vec3 centre(0, 0, i < on_sphere ? 0 : 0.5);
        CHECK((b - a).cross(c - a).dot((a + c) / 2 - centre) < 0);  // the map mirrors
    }
}

TEST_CASE("a ring becomes flat polygons that face where its normal points") {
    LoadResult r = load_objects("s 0 0 0 1\n");
    Scene& scene = *r.scene;
    scene.geometry.primitives = {};
    const Ring ring{{1, 2, 3}, {0, -2, 0}, 1, 2};
    scene.geometry.add(ring, 0);
    CHECK(lost(r) == std::vector<std::string>{"ring, now polygons 1"});
    const LoadResult read = load_p3f_text(write_p3f(scene, r.settings, "").text);
    CHECK(messages(read).empty());
    REQUIRE(read.scene->geometry.primitives.size() == 48);
    double area = 0;
    for (const Polygon& p : read.scene->geometry.all<Polygon>()) {
        const Vec3 cross = (p.corners[2] - p.corners[0]).cross(p.corners[3] - p.corners[1]);
        CHECK(cross.dot(ring.normal) > 0);
        area += cross.length() / 2;
    }
    CHECK(area == Approx(3 * 24 * std::sin(M_PI / 24)));
}

TEST_CASE("glass of constant weights becomes Fresnel's, and a Phong highlight Blinn's") {
    LoadResult r = load_objects("s 0 0 0 1\n");
    Material& m = r.scene->whitted().materials[0];
    m.transmission = Color(0.5F);
    m.ior = 1.3;
    m.specular = Color(0.5F);
    m.highlight = Highlight::phong;
    const std::string fresnel = "constant weights of reflected and refracted rays, now Fresnel's 1";
    CHECK(lost(r) == std::vector<std::string>{"Phong highlight, now Blinn's 1", fresnel});
    CHECK(load_p3f_text(text_of(r)).scene->whitted().materials[0].ior == 1.3);
}
