#include "tests/render/coincident_surfaces.h"

#include "tests/catch.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("of two spheres in the same place the other is taken, and no sphere behind it") {
    TestScene scene = empty_scene();
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    scene.geometry.add(Sphere{Vec3(0, 0, 5), 1}, 0);
    const auto first = find_backend(default_backend)->build(scene.geometry);
    const OtherOfCoincident second(*first);
    const std::vector<Ray> rays{{Vec3(0, 0, -3), Vec3(0, 0, 1)},
                                {Vec3(0, 0, 9), Vec3(0, 0, -1)},
                                {Vec3(0, 3, 0), Vec3(0, 0, 1)}};
    std::vector<Hit> hits(rays.size()), others(rays.size());
    static_cast<const BatchIntersector&>(*first).closest(rays, hits);
    second.closest(rays, others);
    CHECK(hits[0].primitive == 0);
    CHECK(others[0].primitive == 1);
    CHECK(others[0].t == hits[0].t);
    CHECK(others[1].primitive == 2);
    CHECK(others[2].primitive == no_index);
}
