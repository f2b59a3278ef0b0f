#include "core/scene/transformed.h"
#include "tests/catch.h"
#include "tests/formats/prt_text.h"

using namespace etalon;

namespace {

char color(const Scene& scene, const Primitive& p) {
    const Color& c = scene.whitted().materials[p.material].diffuse;
    return c.x == 1 ? 'r' : c.y == 1 ? 'g' : '?';
}

/// Returns the diffuse colours, as letters, of the primitives and then of each instance's
/// primitives.
std::string colors(const LoadResult& r) {
    const Geometry& g = r.scene->geometry;
    std::string letters;
    for (const Primitive p : g.primitives) letters += color(*r.scene, p);
    for (const Instance& instance : g.instances) {
        letters += ' ';
        for (const Primitive p : g.objects[instance.object].primitives) {
            letters += color(*r.scene, p);
        }
    }
    return letters;
}

}  // namespace

TEST_CASE("an instance is nothing until it is referred to, then one object seen each time") {
    const LoadResult r = load_prt_text(
        red +
        "instance all\nsphere 1 0 0 1\ncone 0 0 0 1 0 0 1 1\npolygon 3 0 0 0 1 0 0 0 1 0\n"
        "ring 0 0 0 1 0 0 0 1 0 2 1\nquadric 0 0 0 -1 -1 -1 1 1 1 1 0 0 0 1 0 0 1 0 -1\n"
        "hsphere 0 0 0 2 1\nend_instance\nsphere 9 9 9 9\ninstance_of all 10 20 30\n"
        "instance_of all 0 0 0\n");
    CHECK(messages(r).empty());
    const Geometry& g = r.scene->geometry;
    REQUIRE(g.primitives.size() == 1);
    CHECK(g.all<Sphere>()[0].centre == Vec3(9));
    REQUIRE(g.objects.size() == 1);
    CHECK(g.objects[0].primitives.size() == 7);
    CHECK(g.objects[0].all<Sphere>()[0].centre == Vec3(1, 0, 0));
    REQUIRE(g.instances.size() == 2);
    for (const Instance& instance : g.instances) {
        CHECK(instance.object == 0);
        CHECK(instance.rows == Instance(Affine(), 0).rows);
        CHECK_FALSE(instance.moves());
    }
    CHECK(g.instances[0].origin == Vec3(10, 20, 30));
    CHECK(g.instances[1].origin == Vec3(0));
    CHECK(colors(r) == "r rrrrrrr rrrrrrr");
}

TEST_CASE("a shape of any kind moves with its instance") {
    const Vec3 offset(10, 20, 30);
    const Affine map{{2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {1, 1, 1}};
    Geometry g;
    g.add(Box{Vec3(0), Vec3(1)}, 0);
    g.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    g.add(Ellipsoid(map), 0);
    g.add(ClosedCylinder(map), 0);
    const std::optional<Geometry> m = moved(g, offset);
    REQUIRE(m);
    CHECK(m->all<Box>()[0].min == offset);
    CHECK(m->all<Box>()[0].max == Vec3(1) + offset);
    CHECK(m->all<Plane>()[0].point == offset);
    CHECK(m->all<Ellipsoid>()[0].to_world.origin == Vec3(1) + offset);
    CHECK(m->all<Ellipsoid>()[0].frame.point(Vec3(0)) == Vec3(1) + offset);
    CHECK(m->all<ClosedCylinder>()[0].to_world.origin == Vec3(1) + offset);
    CHECK(m->all<ClosedCylinder>()[0].frame.point(Vec3(0)) == Vec3(1) + offset);
}

TEST_CASE("an instance that is never referred to leaves nothing behind") {
    const LoadResult r =
        load_prt_text("instance a\n" + red + "polygon 4 0 0 0 1 0 0 1 1 0 0 1 0\nend_instance\n");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.primitives.empty());
    CHECK(r.scene->geometry.vertices.empty());
    CHECK(r.scene->whitted().materials.empty());
    CHECK(r.scene->geometry.all<Polygon>().empty());
}

TEST_CASE("objects of an instance take the surface that is current at the reference") {
    const LoadResult r = load_prt_text("instance a\nsphere 0 0 0 1\nend_instance\n" + red +
                                       "instance_of a 0 0 0\n" + green + "instance_of a 1 0 0\n");
    CHECK(messages(r).empty());
    CHECK(colors(r) == " r g");
    CHECK(r.scene->geometry.objects.size() == 2);
}

TEST_CASE("a surface in an instance holds from the reference on, outside too") {
    const LoadResult r = load_prt_text(red + "instance a\nsphere 0 0 0 1\n" + green +
                                       "sphere 1 0 0 1\nend_instance\nsphere 2 0 0 1\n"
                                       "instance_of a 0 0 0\nsphere 3 0 0 1\n"
                                       "instance_of a 0 0 0\n");
    CHECK(messages(r).empty());
    CHECK(colors(r) == "rg rg gg");
}

TEST_CASE("a hollow in an instance is one in the surface of the reference") {
    const LoadResult r = load_prt_text("instance a\nhsphere 0 0 0 1 .5\nend_instance\n" + glass +
                                       "instance_of a 0 0 0\n" + red + "instance_of a 0 0 0\n");
    CHECK(messages(r).empty());
    const auto ior = [&](std::size_t object, std::size_t i) {
        const Primitive p = r.scene->geometry.objects[object].primitives[i];
        return r.scene->whitted().materials[p.material].ior;
    };
    CHECK(ior(0, 0) == 1.5);
    CHECK(ior(0, 1) == 1 / 1.5);
    CHECK(ior(1, 0) == 1);
    CHECK(ior(1, 1) == 1);
}

TEST_CASE("references behind equal surfaces share an object") {
    const LoadResult r =
        load_prt_text("instance a\nsphere 0 0 0 1\nend_instance\n" + red + "instance_of a 0 0 0\n" +
                      green + "instance_of a 1 0 0\n" + red + "instance_of a 2 0 0\n");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.objects.size() == 2);
    CHECK(r.scene->whitted().materials.size() == 2);
    CHECK(colors(r) == " r g r");
}

TEST_CASE("an object with its own surfaces is shared, independent of the current surface") {
    const LoadResult r =
        load_prt_text("instance a\n" + green + "sphere 0 0 0 1\nend_instance\n" + green +
                      "instance_of a 0 0 0\n" + red + "instance_of a 1 0 0\nsphere 3 0 0 1\n");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.objects.size() == 1);
    CHECK(colors(r) == "g g g");
}

TEST_CASE("an instance of a surface alone sets it") {
    const LoadResult r = load_prt_text("instance a\n" + green + "end_instance\n" + red +
                                       "sphere 0 0 0 1\ninstance_of a 0 0 0\nsphere 1 0 0 1\n");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.instances.empty());
    CHECK(r.scene->geometry.objects.empty());
    CHECK(colors(r) == "rg");
}

TEST_CASE("legacy PRT moves the box of a quadric with its instance, but not the quadric") {
    LoadOptions legacy;
    legacy.legacy = true;
    const LoadResult r = load_prt_text(
        red + "instance a\nquadric 5 5 5 -1 -1 -1 1 1 1 1 0 0 0 1 0 0 1 0 -1\nend_instance\n" +
            "instance_of a 1 2 3\ninstance_of a 4 5 6\n",
        legacy);
    const Geometry& g = r.scene->geometry;
    REQUIRE(g.instances.size() == 2);
    for (const Instance& instance : g.instances) {
        const Quadric& q = g.objects[instance.object].all<Quadric>()[0];
        CHECK(q.centre == -instance.origin);
        CHECK(q.clip.min == Vec3(-1));
    }
}

TEST_CASE("a reference before any surface gives its objects a default one, if they need it") {
    const std::string needs = "instance a\nsphere 0 0 0 1\nend_instance\n";
    const LoadResult r = load_prt_text(needs + "instance_of a 0 0 0\n");
    CHECK(messages(r) ==
          Messages{"a.prt:9:1: warning: 'instance_of' before any material; it gets a default one"});
    const std::string has = "instance a\n" + red + "sphere 0 0 0 1\nend_instance\n";
    CHECK(messages(load_prt_text(has + "instance_of a 0 0 0\n")).empty());
}

TEST_CASE("camera, lights and background in an instance count at once, and once") {
    const LoadResult r = load_prt_text(
        "instance a\nlight 1 2 3\nbackground 1 0 0 n\nangle 50\nend_instance\n"
        "background 0 0 1\ninstance_of a 0 0 0\ninstance_of a 0 0 0\n");
    CHECK(messages(r) == Messages{"a.prt:9:1: warning: 'angle' after lights; PRT's document has it "
                                  "before them",
                                  "a.prt:9:1: warning: a second 'angle'; it replaces the first"});
    CHECK(r.scene->whitted().lights.size() == 1);
    CHECK(r.scene->camera.fov_degrees == 50);
    CHECK(r.scene->whitted().environment.background == Color(0, 0, 1));
}

TEST_CASE("errors in an instance are reported once, where it is defined") {
    const LoadResult r = load_prt_text(
        red +
        "instance a\nsphere 0 0 0\nsphere 0 0 0 0\nsphere 0 0 0 1 5\nblob\nend_instance\n"
        "instance_of a 0 0 0\ninstance_of a 1 0 0\n");
    CHECK(
        messages(r) ==
        Messages{"a.prt:9:1: warning: expected a number for the radius of 'sphere', found 'sphere'",
                 "a.prt:9:1: warning: 'sphere' left out: its radius is 0",
                 "a.prt:10:16: warning: expected a keyword after 'sphere', found '5' (words "
                 "skipped: 2)"});
    CHECK(colors(r) == " r r");
}

TEST_CASE("an invalid instance is an error") {
    const auto first_error = [](const std::string& text) {
        const LoadResult r = load_prt_text(red + text);
        CHECK_FALSE(r.scene);
        REQUIRE(r.diagnostics.size() == 1);
        return to_string(r.diagnostics[0]);
    };
    CHECK(first_error("instance a\ninstance b\nsphere 0 0 0 1\nend_instance\nend_instance\n") ==
          "a.prt:8:1: error: an instance inside instance 'a'");
    CHECK(first_error("instance a\ninstance_of a 0 0 0\nend_instance\ninstance_of a 0 0 0\n") ==
          "a.prt:8:1: error: 'instance_of' inside instance 'a'");
    CHECK(first_error("instance_of a 0 0 0\ninstance a\nend_instance\n") ==
          "a.prt:7:1: error: no instance 'a' is defined above");
    CHECK(first_error("end_instance\n") ==
          "a.prt:7:1: error: 'end_instance' without an instance to end");
}

TEST_CASE("a reference without an offset is left out") {
    const LoadResult r =
        load_prt_text(red + "instance a\nsphere 0 0 0 1\nend_instance\ninstance_of a 1 2\n");
    CHECK(messages(r) == Messages{"a.prt:11:1: warning: expected a number for the offset of "
                                  "'instance_of', found the end of the file"});
    CHECK(r.scene->geometry.primitives.empty());
}

TEST_CASE("a second instance of a name does not replace the first") {
    const LoadResult r =
        load_prt_text(red +
                      "instance a\nsphere 0 0 0 1\nend_instance\ninstance a\nsphere 0 0 0 2\n"
                      "end_instance\ninstance_of a 0 0 0\n");
    CHECK(messages(r) ==
          Messages{"a.prt:10:1: warning: a second instance 'a'; the first one stays"});
    CHECK(r.scene->geometry.objects[0].all<Sphere>()[0].radius == 1);
}

TEST_CASE("an instance without an end is left out") {
    const LoadResult r = load_prt_text(red + "sphere 1 1 1 1\ninstance a\nsphere 0 0 0 1\n");
    CHECK(messages(r) == Messages{"a.prt:8:1: warning: instance 'a' has no end; it is left out"});
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("an instance whose position is not finite is left out, its surface with it") {
    const LoadResult r = load_prt_text(red + "instance a\n" + green +
                                       "sphere 1e308 0 0 1\nend_instance\n"
                                       "instance_of a 1e308 0 0\nsphere 0 0 0 1\n");
    CHECK(messages(r) ==
          Messages{"a.prt:11:1: warning: 'instance_of' left out: its position is not finite"});
    CHECK(colors(r) == "r");
}

TEST_CASE("instances that amount to more than memory are an error, soon") {
    std::string text = red + "instance a\n";
    for (int i = 0; i < 20000; ++i) text += "light 0 0 1\n";  // 240,000 bytes
    text += "sphere 0 0 0 1\nend_instance\n";
    const auto is_too_much = [&] {
        const LoadResult r = load_prt_text(text);
        return !r.scene && to_string(r.diagnostics.at(0))
                                   .find("the instances amount to more than 134217728 bytes") !=
                               std::string::npos;
    };
    const std::string alike = text;
    for (int i = 0; i < 1000; ++i) text += "instance_of a 0 0 0\n";
    CHECK_FALSE(is_too_much());
    text = alike;
    SECTION("by different surfaces") {
        for (int i = 0; i < 1000; ++i) {
            text += "surface 0 0 0 0  0 0 0 0  0 0 0  1 1 1  0 0 0  1 " + std::to_string(i + 1) +
                    "\ninstance_of a 0 0 0\n";
        }
    }
    SECTION("at the end of all numbers") {
        for (int i = 0; i < 1000; ++i) text += "instance_of a 1e300 0 0\n";
    }
    CHECK(is_too_much());
}
