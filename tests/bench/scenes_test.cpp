#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <set>

#include "app/common/backends.h"
#include "bench/scenes/bench_families.h"
#include "bench/scenes/bench_scene.h"
#include "core/scene/resize.h"
#include "core/test_rays/ray_sets.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::bench;

namespace {

/// A small size, and its expected number of primitives.
struct Small {
    std::string_view family;
    std::size_t size, primitives;
};

constexpr Small small_scenes[] = {
    {"soup", 3000, 3000},      {"spheres", 3000, 3000},    {"duplicates", 500, 500},
    {"terrain", 3000, 3000},   {"flake", 30000, 30000},    {"stadium", 3000, 3000},
    {"slivers", 20000, 20000}, {"sphereflake", 3, 820},    {"mixed", 3000, 3000},
    {"flat", 3000, 3000},      {"equal", 500, 500},        {"nan", 3000, 3000},
    {"hair", 400, 3200},       {"forest", 500, 502},       {"forest_copies", 50, 20002},
    {"plaza", 600, 602},       {"plaza_copies", 60, 9042},
};

Scene make(const Small& s) {
    return *bench_scene(std::string(s.family) + ":" + std::to_string(s.size)).scene;
}

/// FNV-1a of bytes.
class Hash {
  public:
    template <class T>
    void add(std::span<const T> values) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        for (std::size_t i = 0; i < values.size_bytes(); ++i) {
            value_ = (value_ ^ bytes[i]) * 0x100000001b3U;
        }
    }
    template <class T>
    void add(const LargeVector<T>& values) {
        add(std::span(values));
    }
    void add(const TriangleList& triangles) {
        for (const TriangleIndices t : triangles) add(std::span<const std::uint32_t>(t));
    }
    void add(const PolygonList& polygons) { add(polygons.corners()); }
    void add(const CurveList& curves) {
        for (const StoredCurve& c : curves) add(std::span<const Vec3f>(c.curve.points));
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

void add(const Geometry& geometry, Hash& hash) {
    hash.add(geometry.vertices);
    std::apply([&](const auto&... shapes) { (hash.add(shapes), ...); }, geometry.shapes);
    for (const Instance& i : geometry.instances) hash.add(std::span<const Vec3>(i.rows));
    for (const Geometry& object : geometry.objects) add(object, hash);
}

std::uint64_t hash_of(const Scene& scene) {
    Hash hash;
    add(scene.geometry, hash);
    return hash.value();
}

/// 3 in a soup, 0.5 in a large mesh.
double vertices_per_triangle(const Scene& scene) {
    return static_cast<double>(scene.geometry.vertices.size()) /
           static_cast<double>(scene.geometry.all<Triangle>().size());
}

bool is_finite_triangle(const Scene& scene, const TriangleIndices& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return is_finite(scene.geometry.vertex(v)); });
}

Vec3 sum_of_corners(const Scene& scene, const TriangleIndices& t) {
    return scene.geometry.vertex(t[0]) + scene.geometry.vertex(t[1]) + scene.geometry.vertex(t[2]);
}

}  // namespace

TEST_CASE("Every family of scenes has a line in the test's table") {
    std::set<std::string_view> tested, known;
    for (const Small& s : small_scenes) tested.insert(s.family);
    for (const Family& f : families()) known.insert(f.name);
    CHECK(tested == known);
}

TEST_CASE("Every scene has as many primitives as promised, within a tenth") {
    for (const Small& s : small_scenes) {
        INFO(s.family);
        const auto promised = static_cast<double>(s.primitives);
        CHECK(static_cast<double>(make(s).geometry.item_count()) == Approx(promised).epsilon(0.1));
    }
}

TEST_CASE("Every scene is the same whatever was made before it, and another at another size") {
    std::map<std::string_view, std::uint64_t> forwards, backwards;
    for (const Small& s : small_scenes) forwards[s.family] = hash_of(make(s));
    for (auto small = std::rbegin(small_scenes); small != std::rend(small_scenes); ++small) {
        const Small& s = *small;
        INFO(s.family);
        CHECK(forwards[s.family] != hash_of(make({s.family, s.size / 2, 0})));
        backwards[s.family] = hash_of(make(s));
    }
    CHECK(forwards == backwards);
}

TEST_CASE("The camera of every scene sees something, and something that the light may reach") {
    for (const Small& s : small_scenes) {
        INFO(s.family);
        const Scene scene = make(s);
        const auto bvh = find_backend(default_backend)->build(scene.geometry);
        const Imath::V2i size(64);
        const auto rays = make_ray_set("camera", scene, size, *bvh, 400).rays;
        const auto hits = std::count_if(rays.begin(), rays.end(),
                                        [&](const Ray& ray) { return bvh->occluded(ray); });
        CHECK(hits > 20);
        CHECK(make_ray_set("shadow", scene, size, *bvh, 400).rays.size() > 20);
    }
}

TEST_CASE("A family's name alone is its usual size, as listed") {
    CHECK(bench_scene("sphereflake").scene->geometry.primitives.size() == 7381);
    CHECK(bench_scene("flake").scene->geometry.primitives.size() == 432'962);
    CHECK(bench_scene("stadium").scene->geometry.primitives.size() == 268'000);
    for (const Family& f : families()) {
        CHECK_THAT(list_of_scenes(), ContainsSubstring(std::string(f.name) + ":"));
    }
}

TEST_CASE("Meshes share their vertices") {
    CHECK(vertices_per_triangle(make({"terrain", 3000, 0})) < 0.6);
    CHECK(vertices_per_triangle(make({"flake", 30000, 0})) < 0.6);
    CHECK(vertices_per_triangle(*bench_scene("stadium").scene) < 0.8);  // needles are no mesh
}

TEST_CASE("Needles are as long and as wide as the names of their scenes say") {
    const Scene slivers = make({"slivers", 300, 0});
    for (const TriangleIndices t : slivers.geometry.all<Triangle>()) {
        const Vec3 a = slivers.geometry.vertex(t[0]), b = slivers.geometry.vertex(t[1]),
                   c = slivers.geometry.vertex(t[2]);
        CHECK((a - b).length() == Approx(0.002));
        CHECK((c - (a + b) / 2).length() == Approx(0.24));
    }
}

TEST_CASE("All triangles of equal have their centre in one point, and are no points themselves") {
    const Scene scene = make({"equal", 500, 0});
    for (const TriangleIndices t : scene.geometry.all<Triangle>()) {
        CHECK(sum_of_corners(scene, t) == Vec3(0));
        Box3 box;
        for (const std::uint32_t v : t) box.extendBy(scene.geometry.vertex(v));
        CHECK(box.center() == Vec3(0));
        CHECK(box.size().x > 0);
    }
}

TEST_CASE("Every tenth triangle of nan has a NaN, and no other") {
    const Scene scene = make({"nan", 3000, 0});
    const auto& triangles = scene.geometry.all<Triangle>();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        CHECK(is_finite_triangle(scene, triangles[i]) == (i % 10 != 9));
    }
}

TEST_CASE("All of flat is in one plane, and mixed has every bounded shape in equal shares") {
    for (const Vec3& v : make({"flat", 300, 0}).geometry.vertices) CHECK(v.y == 0);
    const Scene mixed = make({"mixed", 1000, 0});
    CHECK(mixed.geometry.all<Sphere>().size() == 200);
    CHECK(mixed.geometry.all<Cone>().size() == 200);
    CHECK(mixed.geometry.all<Box>().size() == 200);
    CHECK(mixed.geometry.all<Triangle>().size() == 200);
    CHECK(mixed.geometry.all<Polygon>().size() == 200);
}

TEST_CASE("An unknown name or a size out of range is told with what was expected") {
    CHECK_THAT(check_scene_name("soap"),
               ContainsSubstring("soap: no such scene") && ContainsSubstring("stadium[:N]"));
    for (const char* wrong : {"soup:", "soup:0", "soup:many", "soup:12x", "soup:-3", "soup:1e5",
                              "soup:200000000", "soup:99999999999999999999", "sphereflake:9"}) {
        INFO(wrong);
        CHECK_THAT(check_scene_name(wrong), ContainsSubstring("expected "));
        CHECK_FALSE(bench_scene(wrong).scene);
    }
    CHECK(check_scene_name("terrain") == "");
    CHECK(check_scene_name(ETALON_SOURCE_DIR "/scenes/showcase.p3f") == "");
}

TEST_CASE("A scene without instances is hit where the one with them is, at all but the same t") {
    for (const std::string name : {"forest", "plaza"}) {
        CAPTURE(name);
        const Scene instances = *bench_scene(name + ":300").scene;
        const Scene copies = *bench_scene(name + "_copies:300").scene;
        CHECK(copies.geometry.instances.empty());
        const Backend& backend = *find_backend(default_backend);
        const auto a = backend.build(instances.geometry), b = backend.build(copies.geometry);
        std::size_t hits = 0, others = 0;
        for (const Ray& ray : make_ray_set("camera", instances, {64, 64}, *a, 4000).rays) {
            const std::optional<Hit> one = a->closest(ray), other = b->closest(ray);
            if (one) ++hits;
            if (one.has_value() != other.has_value()) ++others;
            if (one && other && !(std::abs(one->t - other->t) <= 1e-9 * one->t)) ++others;
        }
        CHECK(hits > 1000);
        CHECK(others == 0);
    }
}

TEST_CASE("A width gives the height that belongs to it, and the same part as crop window") {
    RenderSettings settings;
    settings.resolution = {400, 200};
    settings.crop = {{100, 50}, {299, 149}};
    set_width(settings, 0);
    CHECK(settings.resolution == Imath::V2i(400, 200));
    set_width(settings, 100);
    CHECK(settings.resolution == Imath::V2i(100, 50));
    CHECK(settings.crop == Imath::Box2i({25, 12 + 1}, {74, 37}));
    settings.resolution = {36000, 36000};
    set_width(settings, 60000);
    CHECK(settings.resolution.y == 60000);
    settings.resolution = {1, 65536};
    set_width(settings, 65536);
    CHECK(settings.resolution.y == max_image_side);
}
