// How Embree's builder sorts primitives into groups.
#include "embree_backend/grouping.h"

#include <algorithm>
#include <numeric>

#include "core/intersect/bounded.h"
#include "tests/backends/scenes.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::vector<RTCBuildPrimitive> build_primitives(const SceneBounds& bounds) {
    std::vector<RTCBuildPrimitive> primitives;
    for (const BoundedPrimitive& p : bounds.bounded) {
        const Vec3f &min = p.min, &max = p.max;
        primitives.push_back({min.x, min.y, min.z, 0, max.x, max.y, max.z, p.id});
    }
    return primitives;
}

Grouping group_all(const SceneBounds& bounds, unsigned most) {
    const EmbreeDevice device;
    Grouping groups;
    group(device, build_primitives(bounds), most, groups);
    return groups;
}

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
}

bool covers(const Grouping& groups, std::size_t i, const SceneBounds& bounds) {
    const Range& range = groups.ranges[i];
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
        const auto p = std::find_if(bounds.bounded.begin(), bounds.bounded.end(),
                                    [&](const auto& b) { return b.id == groups.ids[k]; });
        if (!groups.boxes[i].intersects(p->min) || !groups.boxes[i].intersects(p->max)) {
            return false;
        }
    }
    return true;
}

void require_partition(const SceneBounds& bounds, unsigned most) {
    const Grouping groups = group_all(bounds, most);
    std::vector<std::uint32_t> ids;
    for (const BoundedPrimitive& p : bounds.bounded) ids.push_back(p.id);
    CHECK(sorted(groups.ids) == ids);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < groups.ranges.size(); ++i) {
        const Range& range = groups.ranges[i];
        REQUIRE(range.first == next);
        REQUIRE((range.count >= 1 && range.count <= most));
        next += range.count;
        CHECK(covers(groups, i, bounds));
    }
    CHECK(next == ids.size());
}

}  // namespace

TEST_CASE("Given any scene, each primitive is in one group, and within its box",
          "[backends][embree]") {
    for (const SceneFamily& family : scene_families()) {
        INFO(family.name);
        const Scene scene = family.make(500);
        for (const unsigned most : {1, 8}) require_partition(SceneBounds::of(scene), most);
    }
}

TEST_CASE("Given a second set of primitives, its groups come after those of the first",
          "[backends][embree]") {
    const EmbreeDevice device;
    const Scene scene = make_scene("spheres", 20);
    const auto primitives = build_primitives(SceneBounds::of(scene));
    Grouping groups;
    group(device, primitives, 8, groups);
    const std::size_t first = groups.ranges.size();
    group(device, primitives, 8, groups);
    REQUIRE(groups.ranges.size() == 2 * first);
    REQUIRE(groups.boxes.size() == 2 * first);
    CHECK(groups.ranges[first].first == 20);
    CHECK(groups.boxes[first] == groups.boxes[0]);
}

TEST_CASE("Given many primitives, groups of eight are four fifths full and more",
          "[backends][embree]") {
    for (const char* family : {"spheres", "triangles", "closed_mesh", "slivers"}) {
        INFO(family);
        const Scene scene = make_scene(family, 20000);
        const SceneBounds bounds = SceneBounds::of(scene);
        const Grouping groups = group_all(bounds, 8);
        CHECK(10 * bounds.bounded.size() > 8 * 8 * groups.ranges.size());
    }
}

TEST_CASE("Given ever smaller primitives about a point, or copies of one, groups hold no more",
          "[backends][embree]") {
    Scene scene;
    for (int i = 0; i < 2000; ++i) {
        const double size = std::exp2(-i % 140);
        scene.add(Sphere{Vec3(size), size / 8}, 0);
        scene.add(Sphere{Vec3(1), 0.5}, 0);
    }
    require_partition(SceneBounds::of(scene), 8);
}
