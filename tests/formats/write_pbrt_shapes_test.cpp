// Shapes written as PBRT v3.
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/sce_text.h"
#include "tests/formats/written_pbrt.h"

using namespace etalon;

namespace {

std::vector<std::string> shape_types(const std::vector<Directive>& list) {
    std::vector<std::string> types;
    for (const Directive& d : list) {
        if (d.name == "Shape") types.push_back(d.type);
    }
    return types;
}

}  // namespace

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
