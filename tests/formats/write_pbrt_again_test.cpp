// Shapes of PBRT v3 that are written again, and read as the same shapes.
#include "core/formats/write/write.h"
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

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
