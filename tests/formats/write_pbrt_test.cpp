// Scenes written as PBRT v3, checked by the rules of its parser.
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "core/color/srgb.h"
#include "core/convert/physical_scene.h"
#include "core/formats/write/write.h"
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

/// A directive with the numbers and names that follow it.
struct Directive {
    std::string name, type;
    std::vector<double> numbers;                             ///< those before any parameter
    bool bracketed = false;                                  ///< whether they were in brackets
    std::map<std::string, std::vector<std::string>> values;  ///< "float fov" -> 45
};

/// Words, and strings with their quotes.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    std::istringstream in(text);
    for (std::string word; in >> word;) {
        while (word.front() == '"' && (word.size() == 1 || word.back() != '"')) {
            std::string more;
            REQUIRE(in >> more);
            word += " " + more;
        }
        tokens.push_back(word);
    }
    return tokens;
}

std::string unquoted(const std::string& token) {
    return token.substr(1, token.size() - 2);
}

std::vector<Directive> directives_of(const std::string& text) {
    const std::vector<std::string> tokens = tokens_of(text);
    std::vector<Directive> list;
    for (std::size_t i = 0; i < tokens.size();) {
        Directive d{tokens[i++], {}, {}, false, {}};
        REQUIRE(std::isalpha(static_cast<unsigned char>(d.name[0])));
        if (i < tokens.size() && tokens[i][0] == '"') d.type = unquoted(tokens[i++]);
        std::vector<std::string>* values = nullptr;
        for (; i < tokens.size() && !std::isalpha(static_cast<unsigned char>(tokens[i][0])); ++i) {
            const std::string& token = tokens[i];
            if (token == "[" || token == "]") {
                if (!values) d.bracketed = true;
            } else if (token[0] == '"' && token.find(' ') != token.npos) {
                values = &d.values[unquoted(token)];
            } else if (values) {
                values->push_back(token);
            } else {
                d.numbers.push_back(std::stod(token));
            }
        }
        list.push_back(std::move(d));
    }
    return list;
}

void check_parameters(const Directive& d) {
    const std::map<std::string, std::size_t> sizes = {{"point", 3}, {"normal", 3}, {"rgb", 3}};
    for (const auto& [name, values] : d.values) {
        CAPTURE(d.name, d.type, name);
        const std::string type = name.substr(0, name.find(' '));
        CHECK_FALSE(values.empty());
        const bool text = type == "string" || type == "bool";
        if (sizes.contains(type)) CHECK(values.size() % sizes.at(type) == 0);
        if (type == "float" || type == "string" || type == "bool") CHECK(values.size() == 1);
        for (const std::string& v : values) CHECK((v[0] == '"') == text);
    }
    if (d.type != "trianglemesh") return;
    const std::size_t vertices = d.values.at("point P").size() / 3;
    for (const std::string& index : d.values.at("integer indices")) {
        CHECK(std::stoul(index) < vertices);
    }
    if (d.values.contains("normal N")) CHECK(d.values.at("normal N").size() == 3 * vertices);
}

/// Parses as strictly as PBRT: fixed counts, brackets for matrices only, names defined before use,
/// closed blocks, options before the world.
std::vector<Directive> parsed(const std::string& text) {
    const std::map<std::string, std::size_t> counts = {
        {"LookAt", 9}, {"Scale", 3}, {"Transform", 16}};
    const std::set<std::string> options = {"LookAt", "Scale",       "Camera",    "Sampler",
                                           "Film",   "PixelFilter", "Integrator"};
    std::vector<Directive> list = directives_of(text);
    std::set<std::string> materials;
    std::vector<std::string> open;
    for (const Directive& d : list) {
        CAPTURE(d.name, d.type);
        CHECK(d.numbers.size() == (counts.contains(d.name) ? counts.at(d.name) : 0));
        CHECK(d.bracketed == (d.name == "Transform"));
        CHECK(options.contains(d.name) == (open.empty() && !d.name.ends_with("Begin")));
        check_parameters(d);
        if (d.name == "MakeNamedMaterial") materials.insert(d.type);
        if (d.name == "NamedMaterial") CHECK(materials.contains(d.type));
        if (d.name.ends_with("Begin")) open.push_back(d.name.substr(0, d.name.size() - 5));
        if (!d.name.ends_with("End")) continue;
        REQUIRE_FALSE(open.empty());
        CHECK(open.back() + "End" == d.name);
        open.pop_back();
    }
    CHECK(open.empty());
    CHECK(list.back().name == "WorldEnd");
    return list;
}

std::vector<Directive> converted(const LoadResult& r) {
    REQUIRE(r.scene);
    return parsed(write_pbrt(*r.scene, r.settings, "").text);
}

const Directive& find(const std::vector<Directive>& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, &Directive::name);
    REQUIRE(found != list.end());
    return *found;
}

std::vector<std::string> shape_types(const std::vector<Directive>& list) {
    std::vector<std::string> types;
    for (const Directive& d : list) {
        if (d.name == "Shape") types.push_back(d.type);
    }
    return types;
}

double number(const Directive& d, const std::string& name) {
    REQUIRE(d.values.contains(name));
    return std::stod(d.values.at(name).at(0));
}

using Strings = std::vector<std::string>;

}  // namespace

TEST_CASE("a scene of every feature becomes one that PBRT's parser takes") {
    for (const auto& entry : fs::directory_iterator(ETALON_SOURCE_DIR "/scenes/features")) {
        if (entry.path().extension() != ".p3f") continue;
        CAPTURE(entry.path());
        converted(load_scene(entry.path().string()));
    }
}

TEST_CASE("the camera is turned right-handed, its angle is that of the shorter side") {
    const auto wide = converted(load_statements(""));
    CHECK(find(wide, "Scale").numbers == std::vector<double>{-1, 1, 1});
    CHECK(find(wide, "LookAt").numbers == std::vector<double>{0, 0, 5, 0, 0, 0, 0, 1, 0});
    CHECK(number(find(wide, "Camera"), "float fov") == 45);
    CHECK(number(find(wide, "Film"), "integer xresolution") == 40);
    CHECK(number(find(wide, "Integrator"), "integer maxdepth") == physical_depth - 1);
    CHECK(number(find(wide, "Sampler"), "integer pixelsamples") == physical_samples);
    std::string tall = good_camera;
    tall.replace(tall.find("40 30"), 5, "30 60");
    const double fov = number(find(converted(load_p3f_text(tall)), "Camera"), "float fov");
    CHECK(std::tan(fov * M_PI / 360) == Approx(std::tan(22.5 * M_PI / 180) / 2));
}

TEST_CASE("a lens has its radius and its plane of focus") {
    std::string text = good_camera + "spp 4\n";
    text.replace(text.find("aperture 0\nfocal 1"), 18, "aperture 3\nfocal 2");
    const auto list = converted(load_p3f_text(text));
    const double pixel = 2 * 5 * std::tan(22.5 * M_PI / 180) / 30;
    CHECK(number(find(list, "Camera"), "float lensradius") == Approx(1.5 * pixel));
    CHECK(number(find(list, "Camera"), "float focaldistance") == Approx(10));
    CHECK(number(find(list, "Sampler"), "integer pixelsamples") == 4);
}

TEST_CASE("shapes become what PBRT has for them") {
    const auto list = converted(load_objects(
        "s 1 2 3 0.5\nc 0 0 0 1 0 0 2 1\nc 0 0 0 1 0 0 2 0\nc 0 0 0 0 0 0 2 1\nc 0 0 0 1 0 0 2 .5\n"
        "box 0 0 0 1 1 1\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nmesh 3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n"
        "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\npl 0 0 0 1 0 0 0 1 0\n"));
    CHECK(shape_types(list) == Strings{"sphere", "cylinder", "cone", "cone", "trianglemesh",
                                       "trianglemesh", "trianglemesh", "trianglemesh",
                                       "trianglemesh", "trianglemesh"});
    CHECK(find(list, "Transform").numbers ==
          std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1});
    const auto solids = converted(load_sce_text("scale 1 1 2\nball 1 0 0 0\ncylinder\n"));
    CHECK(shape_types(solids) == Strings{"sphere", "cylinder", "disk", "disk"});

    LoadResult ring = load_objects("");
    ring.scene->whitted().materials.emplace_back();
    ring.scene->geometry.add(Ring{{1, 2, 3}, {0, 0, 4}, 0.5, 2}, 0);
    const auto disk = converted(ring);
    CHECK(number(find(disk, "Shape"), "float radius") == 2);
    CHECK(number(find(disk, "Shape"), "float innerradius") == 0.5);
    const std::vector<double> place = find(disk, "Transform").numbers;
    CHECK(std::vector(place.begin() + 8, place.end()) ==
          std::vector<double>{0, 0, 1, 0, 1, 2, 3, 1});
}

TEST_CASE("a truncated cone becomes triangles whose corners lie on it, with its normals") {
    const LoadResult before = load_objects("c 1 0 0 1.5 1 2 0 0.5\n");
    const WrittenScene written = write_pbrt(*before.scene, before.settings, "");
    REQUIRE(written.lost.size() == 1);
    CHECK(written.lost[0].what == "truncated cone, now triangles");
    const LoadResult after = load_scene_text(written.text, "cone.pbrt", {});
    REQUIRE(after.scene);
    const Geometry& mesh = after.scene->geometry;
    REQUIRE(mesh.all<Triangle>().size() == 96);
    std::size_t at_base = 0;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const Triangle t = mesh.get<Triangle>(mesh.primitives[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = mesh.vertex(t.vertices[k]);
            const double radius = std::hypot(p.x - 1, p.z);
            CHECK(radius == Approx(1.5 - p.y / 2));
            const Vec3 n = mesh.normals[Geometry::normal_number(t, k)];
            const Vec3 outward((p.x - 1) / radius, 0.5, p.z / radius);
            CHECK(n.dot(outward) == Approx(std::sqrt(n.dot(n) * outward.dot(outward))));
            if (p.y == 0) ++at_base;
        }
    }
    CHECK(at_base == 144);
}

TEST_CASE("a box without extent along an axis becomes one face") {
    for (const char* box : {"box 0 -1 -1 0 1 2", "box -1 0 -1 1 0 2", "box -1 -1 0 1 2 0"}) {
        CAPTURE(box);
        const LoadResult before = load_objects(std::string(box) + "\n");
        const WrittenScene written = write_pbrt(*before.scene, before.settings, "");
        const LoadResult after = load_scene_text(written.text, "box.pbrt", {});
        CHECK(messages(after).empty());
        REQUIRE(after.scene);
        const Geometry& mesh = after.scene->geometry;
        REQUIRE(mesh.primitives.size() == 2);
        double area = 0;
        for (const std::uint32_t i : {0U, 1U}) {
            const Triangle t = mesh.get<Triangle>(mesh.primitives[i]);
            const Vec3 a = mesh.vertex(t.vertices[0]), b = mesh.vertex(t.vertices[1]);
            area += (b - a).cross(mesh.vertex(t.vertices[2]) - a).length() / 2;
        }
        CHECK(area == 6);
    }
}

namespace {

Strings names_of(const std::vector<ConversionWarning>& lost) {
    Strings list;
    for (const ConversionWarning& warning : lost) list.push_back(warning.what);
    return list;
}

}  // namespace

TEST_CASE("a scene far from the origin is moved there, as its coordinates become floats") {
    const std::string camera =
        "camera\neye 4500000 500000 5\nat 4500000 500000 0\nup 0 1 0\nangle 45\nhither 0\n"
        "resolution 40 30\naperture 0\nfocal 1\n";
    const LoadResult before =
        load_p3f_text(camera + good_material + "l 4500000.3 500000.1 2 1 1 1\n" +
                      "p 3 4500000.1 500000 0 4500000.2 500000 0 4500000.1 500000.1 0\n");
    const WrittenScene written = write_pbrt(*before.scene, before.settings, "");
    CHECK(names_of(written.lost) == Strings{"light that does not fall off, now one that does"});
    const LoadResult after = load_scene_text(written.text, "far.pbrt", {});
    CHECK(messages(after).empty());
    const Geometry& mesh = after.scene->geometry;
    REQUIRE(mesh.primitives.size() == 1);
    const std::array corners = {Vec3(.1, 0, -5), Vec3(.2, 0, -5), Vec3(.1, .1, -5)};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Vec3 corner = mesh.vertex(mesh.get<Triangle>(mesh.primitives[0]).vertices[i]);
        CHECK(max_abs(corner - corners[i]) < 1e-7);
    }
    const auto& light = std::get<PointSource>(after.scene->physical().lights.at(0));
    CHECK(max_abs(light.position - Vec3(.3, .1, -3)) < 1e-7);
}

TEST_CASE("a mesh that floats cannot express where it is is listed") {
    const LoadResult r = load_objects("p 3 100000.1 0 0 100000.2 0 0 100000.1 .1 0\n");
    CHECK(names_of(write_pbrt(*r.scene, r.settings, "").lost) ==
          Strings{"mesh that is too small for its distance from the origin"});
}

TEST_CASE("faces without area are left out") {
    const LoadResult before = load_objects(
        "p 5 -1 -1 0 1 -1 0 1 1 0 -1 1 0 -1 -1 0\n"
        "mesh 4 2\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 2 3\n1 2 4\n");
    LoadOptions strict;
    strict.strict = true;
    const LoadResult after =
        load_scene_text(write_pbrt(*before.scene, before.settings, "").text, "faces.pbrt", strict);
    CHECK(messages(after).empty());
    CHECK(after.scene->geometry.primitives.size() == 3);
}

TEST_CASE("a polygon that PBRT shows otherwise is listed") {
    const auto lost = [](const std::string& polygon) {
        const LoadResult r = load_objects(polygon + "\n");
        REQUIRE(r.scene);
        return names_of(write_pbrt(*r.scene, r.settings, "").lost);
    };
    CHECK(lost("p 5 .1 .1 .7 .3 .1 .7 .3 .3 .7 .2 .2 .7 .1 .3 .7").empty());
    CHECK(lost("p 4 0 0 0 .1 0 .1 .1 .1 .2 0 .1 .1").empty());
    CHECK(lost("pp 4 0 0 0 0 0 1 1 0 0 0 1 1 1 1 0 0 0 1 0 1 0 0 0 1") ==
          Strings{"smooth polygon, now triangles"});
    CHECK(lost("p 4 -1 -1 0 1 -1 0 1 1 1 -1 1 0") ==
          Strings{"polygon that is not planar, now triangles"});
    CHECK(lost("p 5 0 3 0 2 -3 0 -3 1 0 3 1 0 -2 -3 0") ==
          Strings{"polygon that crosses itself, now triangles that cover other parts"});
}

TEST_CASE("materials become the nearest of PBRT's") {
    const auto types = [](const std::string& statement) {
        Strings list;
        for (const Directive& d : converted(load_statements(statement + "\ns 0 0 0 1\n"))) {
            if (d.name == "MakeNamedMaterial") list.push_back(d.values.at("string type")[0]);
        }
        return list;
    };
    CHECK(types("mat 1 1 1 0.5 1 1 1 0 10 0 1") == Strings{"\"matte\""});
    CHECK(types("mat 0 0 0 0 1 1 1 0 10 1 1.5") == Strings{"\"glass\""});
    CHECK(types("mat 1 1 1 0.5 1 1 1 0.5 10 0 1") == Strings{"\"uber\"", "\"mirror\"", "\"mix\""});
    CHECK(types("mat 1 1 1 0.5 1 1 1 -0.5 10 0 1") == Strings{"\"matte\""});
}

TEST_CASE("a light is as bright at the point looked at as it was") {
    const auto list = converted(load_statements("l 0 0 2 0.5 0.25 1\nl 3 0 0 1 1 1"));
    const Directive& light = find(list, "LightSource");
    CHECK(light.type == "point");
    CHECK(number(light, "rgb I") == Approx(srgb_decoded(0.5) * M_PI * 4));
    const auto area = converted(load_statements("light quad 0 0 2 1 1 1 2 0 2 0 2 2 9"));
    CHECK(number(find(area, "AreaLightSource"), "rgb L") ==
          Approx(M_PI * 6 / 4 / (2 / std::sqrt(6.0))));
}

TEST_CASE("what PBRT cannot say is listed") {
    const LoadResult r =
        load_objects("bclr 1 1 1\nl 0 0 2 1 1 1\ns 0 0 0 -1\npl 0 0 0 1 0 0 0 1 0\n");
    CHECK(names_of(write_pbrt(*r.scene, r.settings, "").lost) ==
          Strings{"background that lights nothing, now one that does",
                  "light that does not fall off, now one that does",
                  "shape of which one side is seen", "infinite plane, now a large square"});
}

namespace {

/// Returns the geometry of a PBRT file's shapes, in a scene with Whitted materials.
LoadResult with_shapes_of(const std::string& world) {
    LoadResult from = load_scene_text("WorldBegin\n" + world + "\nWorldEnd\n", "a.pbrt", {});
    REQUIRE(from.scene);
    LoadResult to = load_objects("");
    to.scene->whitted().materials.resize(64);
    to.scene->geometry = std::move(from.scene->geometry);
    return to;
}

void check_same(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i) CHECK(a[i] == Approx(b[i]).margin(1e-6));
}

void check_same(const Affine& a, const Affine& b) {
    check_same(a.x, b.x);
    check_same(a.y, b.y);
    check_same(a.z, b.z);
    check_same(a.origin, b.origin);
}

void check_same(const TurningDirection& a, const TurningDirection& b) {
    check_same(Vec3(a.at.x, a.at.y, 0), Vec3(b.at.x, b.at.y, 0));
    check_same(Vec3(a.per_height.x, a.per_height.y, 0), Vec3(b.per_height.x, b.per_height.y, 0));
}

void check_same(const Revolved& a, const Revolved& b) {
    check_same(a.to_world, b.to_world);
    const Profile &p = a.profile, &q = b.profile;
    CHECK(p.along == q.along);
    CHECK(p.falls == q.falls);
    check_same(Vec3(p.squares[0], p.squares[1], p.squares[2]),
               Vec3(q.squares[0], q.squares[1], q.squares[2]));
    check_same(Vec3(p.low, p.high, a.sector.angle), Vec3(q.low, q.high, b.sector.angle));
    check_same(a.sector.from, b.sector.from);
    CHECK(a.sector.is_whole == b.sector.is_whole);
}

/// Writes the shapes of `world` and reads them again.
std::pair<Geometry, Geometry> written_again(const std::string& world) {
    const LoadResult before = with_shapes_of(world);
    const WrittenScene written = write_pbrt(*before.scene, before.settings, "");
    CHECK(written.lost.empty());
    LoadResult after = load_scene_text(written.text, "b.pbrt", {});
    REQUIRE(after.scene);
    return {before.scene->geometry, std::move(after.scene->geometry)};
}

constexpr const char* revolved_shapes[] = {
    "\"cylinder\" \"float radius\" 2 \"float zmin\" -3 \"float zmax\" .5",
    "\"cylinder\" \"float phimax\" 100",
    "\"cone\" \"float radius\" .5 \"float height\" 3 \"float phimax\" 270",
    "\"paraboloid\" \"float radius\" 3 \"float zmin\" .25 \"float zmax\" 2 \"float phimax\" 90",
    "\"hyperboloid\" \"point p1\" [1 0 -1] \"point p2\" [.5 1 2] \"float phimax\" 200",
    "\"hyperboloid\" \"point p1\" [1 .5 3] \"point p2\" [2 0 0]",
    "\"hyperboloid\" \"point p1\" [0 .5 3] \"point p2\" [2 0 -1]",
    "\"sphere\" \"float radius\" 2 \"float zmin\" -1 \"float zmax\" 1.9",
    "\"sphere\" \"float phimax\" 33",
    "\"disk\" \"float radius\" 3 \"float innerradius\" 1 \"float height\" 2 \"float phimax\" 45",
};

}  // namespace

TEST_CASE("surfaces of revolution become PBRT's shapes that are read as the same surfaces") {
    for (const char* shape : revolved_shapes) {
        CAPTURE(shape);
        const auto [before, after] = written_again(
            std::string("Translate 1 2 3 Rotate 30 1 2 0 Scale 1 2 3 Shape ") + shape);
        REQUIRE(before.all<Revolved>().size() == 1);
        REQUIRE(after.all<Revolved>().size() == 1);
        check_same(before.all<Revolved>()[0], after.all<Revolved>()[0]);
    }
}

TEST_CASE("a surface of revolution of no shape that PBRT has is listed") {
    LoadResult r = with_shapes_of("");
    const Profile bulge{Profile::Along::height, {1, 1, -1}, 0, 1};
    r.scene->geometry.add(Revolved(Affine{}, bulge, Sector(360)), 0);
    const WrittenScene written = write_pbrt(*r.scene, r.settings, "");
    REQUIRE(written.lost.size() == 1);
    CHECK(written.lost[0].what == "surface of revolution of no shape that PBRT has, left out");
}

TEST_CASE("curves become PBRT's, each once, to the bit") {
    const auto [before, after] = written_again(
        "Translate 1 2 3 Rotate 30 1 2 0 Shape \"curve\" \"float width0\" .1 \"float width1\" .3 "
        "\"point P\" [0 0 0 1 0 0 1 1 0 0 1 .1 0 1 2 3 1 4 5 6 7] \"integer splitdepth\" 2\n"
        "Shape \"curve\" \"string type\" \"ribbon\" \"point P\" [0 0 0 1 0 0 1 1 0 0 1 .1] "
        "\"normal N\" [0 0 1 0 1 .5]\n"
        "Shape \"curve\" \"string type\" \"cylinder\" \"string basis\" \"bspline\" \"integer "
        "degree\" 2 \"point P\" [0 0 0 1 0 0 1 1 0 0 1 .1] \"integer splitdepth\" 0\n");
    const CurveList &a = before.all<Curve>(), &b = after.all<Curve>();
    REQUIRE(a.size() == 2 * 4 + 8 + 2);
    REQUIRE(b.size() == a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CAPTURE(i);
        CHECK(a[i].curve == b[i].curve);
        CHECK(a[i].part.number == b[i].part.number);
        CHECK(a[i].part.count == b[i].part.count);
        check_same(a[i].place.to_world, b[i].place.to_world);
    }
}
