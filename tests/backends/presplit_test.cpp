// Triangles split before the BVH is built: what the boxes of the pieces must contain, and where
// they are used.
#include "core/accel/tree/presplit.h"

#include <algorithm>

#include "core/accel/tree/scene_tree.h"
#include "core/accel/tree/triangle_pieces.h"
#include "core/parallel/parallel.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr std::size_t dense_triangles = 4000, needles = 400;

using WorldCorners = std::array<Vec3, 3>;

void add(Scene& scene, const WorldCorners& corners) {
    const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
    scene.geometry.vertices.insert(scene.geometry.vertices.end(), corners.begin(), corners.end());
    scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
}

/// Small triangles near the origin.
Scene dense_scene() {
    Scene scene;
    scene.whitted().materials = {Material()};
    scene.camera.eye = Vec3(0.3, 0.2, 0.4);
    Random random(1);
    for (std::size_t i = 0; i < dense_triangles; ++i) {
        const Vec3 place = 0.05 * random.direction();
        add(scene, {place, place + 0.003 * random.in_cube(), place + 0.003 * random.in_cube()});
    }
    return scene;
}

/// The same among randomly oriented needles.
Scene scene_of_needles() {
    Scene scene = dense_scene();
    Random random(2);
    for (std::size_t i = 0; i < needles; ++i) {
        const Vec3 along = 3.0 * random.direction(), from = random.in_cube() - along / 2;
        add(scene, {from, from + along, from + 0.01 * random.in_cube()});
    }
    return scene;
}

/// The same above two far larger triangles.
Scene scene_on_a_slope() {
    Scene scene = dense_scene();
    const Vec3 a(-5, -3, -5), b(5, 0, -5), c(5, 2, 5), d(-5, -1, 5);
    add(scene, {a, b, c});
    add(scene, {a, c, d});
    return scene;
}

/// Returns an exact point of a triangle whose vertices are integers below 2^40.
Vec3 point_of(const WorldCorners& corners, Random& random) {
    const std::uint32_t a = random.index(65), b = random.index(65 - a);
    const double u = a / 64.0, v = b / 64.0;
    return corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
}

/// Returns a triangle with integer coordinates around a point, most often a needle.
WorldCorners whole_corners(const Vec3& place, Random& random) {
    const auto whole = [](Vec3 v) {
        for (int k = 0; k < 3; ++k) v[k] = std::round(v[k]);
        return v;
    };
    const Vec3 along = whole(random.magnitude(1, 6) * random.direction());
    const Vec3 aside = whole(random.magnitude(1, 6) * random.direction());
    return {place, place + along, place + along / (random.one_in(2) ? 1 : 2) + aside};
}

std::vector<Bounds> pieces_of(const Corners& corners, int cuts) {
    std::vector<Bounds> pieces;
    add_pieces(corners, bounds_of(corners), cuts, pieces);
    return pieces;
}

/// Returns whether a box contains a point, up to the error by which boxes of pieces may be too
/// small.
bool holds(const Bounds& box, const Vec3& point) {
    constexpr double error = piece_error;
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        inside = inside && point[k] >= box.min[k] - error && point[k] <= box.max[k] + error;
    }
    return inside;
}

bool hold(const std::vector<Bounds>& boxes, const Vec3& point) {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Bounds& box) { return holds(box, point); });
}

bool is_within(const Bounds& inner, const Bounds& outer) {
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
        inside = inside && inner.min[k] >= outer.min[k] && inner.max[k] <= outer.max[k];
    }
    return inside;
}

float half_area(const std::vector<Bounds>& boxes) {
    float sum = 0;
    for (const Bounds& box : boxes) sum += box.half_area();
    return sum;
}

std::vector<Box3f> boxes_of(std::uint32_t id, const std::vector<BoundedPrimitive>& references) {
    std::vector<Box3f> boxes;
    for (const BoundedPrimitive& p : references) {
        if (p.id == id) boxes.push_back(p.box());
    }
    return boxes;
}

BvhTree tree_of(const Scene& scene) {
    SceneBounds bounds = SceneBounds::of(scene.geometry);
    return build_scene_bvh(scene.geometry, bounds.space, std::move(bounds.bounded));
}

}  // namespace

TEST_CASE(
    "Given a triangle anywhere, the boxes of its pieces hold all of it and are within its own") {
    Random random(3);
    int outside = 0, lost = 0, too_many = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 place = std::round(random.magnitude(0, 12)) * Vec3(1, -1, 0);
        const WorldCorners world = whole_corners(place, random);
        Box3 box;
        for (const Vec3& corner : world) box.extendBy(corner);
        const double around = random.magnitude(0, 6);
        const NormalizedSpace space(Box3(box.min - Vec3(around), box.max + Vec3(10 * around)));
        const Corners corners = corners_in(space, world);
        const int cuts = random.index(40);
        const std::vector<Bounds> pieces = pieces_of(corners, cuts);
        too_many += pieces.size() > static_cast<std::size_t>(cuts) + 1;
        for (const Bounds& piece : pieces) outside += !is_within(piece, bounds_of(corners));
        for (const Vec3& corner : world) lost += !hold(pieces, space.point(corner));
        for (int k = 0; k < 50; ++k) {
            lost += !hold(pieces, space.point(point_of(world, random)));
        }
    }
    CHECK(lost == 0);
    CHECK(outside == 0);
    CHECK(too_many == 0);
}

TEST_CASE("Given a needle across normalized space, its pieces have far less surface") {
    const WorldCorners needle{Vec3(-1, -1, -1), Vec3(1, 1, 1), Vec3(-1, -1, -0.99)};
    const Corners corners = corners_in(NormalizedSpace(Box3(Vec3(-1), Vec3(1))), needle);
    const std::vector<Bounds> pieces = pieces_of(corners, 15);
    CHECK(pieces.size() == 16);
    CHECK(half_area(pieces) < bounds_of(corners).half_area() / 3);
}

TEST_CASE("Given needles, all primitives keep references whose boxes hold them") {
    const Scene scene = scene_of_needles();
    const SceneBounds bounds = SceneBounds::of(scene.geometry);
    const auto split = presplit(scene.geometry, bounds.space, bounds.bounded);
    REQUIRE(split);
    const std::vector<BoundedPrimitive>& references = split->references;
    CHECK(references.size() > bounds.bounded.size() + needles);
    const auto whole = static_cast<double>(bounds.bounded.size());
    CHECK(static_cast<double>(references.size()) <= whole * (1 + PresplitConfig().budget));
    Random random(4);
    std::size_t lost = 0;
    for (std::uint32_t id = 0; id < scene.geometry.primitives.size(); id += 7) {
        const std::vector<Box3f> boxes = boxes_of(id, references);
        const auto& v = scene.geometry.get<Triangle>(scene.geometry.primitives[id]).vertices;
        const WorldCorners corners{scene.geometry.vertex(v[0]), scene.geometry.vertex(v[1]),
                                   scene.geometry.vertex(v[2])};
        for (int k = 0; k < 50; ++k) {
            const Vec3 point = bounds.space.point(point_of(corners, random));
            // The padding is 26 units of rounding; half of it must be left around the point.
            const Box3 around(point - Vec3(13 * 0x1p-24), point + Vec3(13 * 0x1p-24));
            lost += std::none_of(boxes.begin(), boxes.end(), [&](const Box3f& box) {
                const Box3 b(Vec3(box.min), Vec3(box.max));
                return b.intersects(point) &&
                       (b.intersects(around.min) || b.intersects(around.max));
            });
        }
    }
    CHECK(lost == 0);
}

TEST_CASE("Given needles, a tree of pieces is chosen, the same for any number of threads") {
    const Scene scene = scene_of_needles();
    const auto ids = [&](int threads) {
        const ThreadLimit limit(threads);
        return tree_of(scene).ids;
    };
    const std::vector<std::uint32_t> alone = ids(1);
    CHECK(alone.size() > scene.geometry.primitives.size());
    CHECK(alone == ids(2));
    CHECK(alone == ids(7));
}

TEST_CASE("Given what is not carried by needles, the tree is of whole primitives") {
    for (const Scene& scene : {dense_scene(), scene_on_a_slope(), make_scene("spheres", 1000)}) {
        CHECK(tree_of(scene).ids.size() == SceneBounds::of(scene.geometry).bounded.size());
    }
}

TEST_CASE("Given needles in pieces, every backend finds what the kernels find") {
    const Scene scene = scene_of_needles();
    std::vector<std::unique_ptr<Intersector>> intersectors;
    for (const Backend& backend : exact_backends())
        intersectors.push_back(backend.build(scene.geometry));
    Random random(5);
    std::size_t hits = 0, different = 0;
    for (const Ray& ray : make_rays(scene, 200, random)) {
        if (max_abs(ray.direction) == 0 || !(ray.tmin < ray.tmax)) continue;
        const std::optional<Hit> expected = brute_force(scene, ray);
        hits += expected.has_value();
        for (const auto& intersector : intersectors) {
            different += !difference(*intersector, ray, expected).empty();
        }
    }
    CHECK(hits > 30);
    CHECK(different == 0);
}
