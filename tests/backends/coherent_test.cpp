// Rays marked as coherent are traversed by other code, which must find the same hits.
#include "core/accel/wide/lane_select.h"
#include "core/accel/wide/wide_tree.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("Given any lanes, the lowest found by branches is the one found without", "[backends]") {
    for (std::uint32_t mask = 1; mask < 256; ++mask) {
        CAPTURE(mask);
        CHECK(BranchingLaneSelect::of(mask) == BranchlessLaneSelect::of(mask));
    }
}

TEST_CASE("Given the hint that rays are coherent, true or not, no hit changes", "[backends]") {
    for (const SceneFamily& family : scene_families()) {
        const Scene scene = family.make(300);
        Random random(11);
        const std::vector<Ray> rays = make_rays(scene, 500, random);
        for (const Backend& backend : exact_backends()) {
            INFO(family.name << ", backend " << backend.name);
            const auto intersector = backend.build(scene.geometry);
            std::size_t different = 0;
            for (Ray ray : rays) {
                const std::optional<Hit> alone = intersector->closest(ray);
                ray.set_coherent();
                different += !difference(*intersector, ray, alone).empty();
            }
            CHECK(different == 0);
        }
    }
}

TEST_CASE("Given a node of two halves, a random line enters as many as their surfaces say",
          "[backends]") {
    // The root [0,2]x[0,1]x[0,1] has nine leaves: eight in one node of the left half, and one.
    const auto box = [](float from, float to) { return Box3f(Vec3f(from, 0, 0), Vec3f(to, 1, 1)); };
    std::vector<BvhNode> nodes(2);
    const auto grow = [&](const auto& self, std::size_t at, const Box3f& bounds,
                          std::uint32_t leaves, std::uint32_t first) -> void {
        nodes[at].box = bounds;
        if (leaves == 1) {
            nodes[at].first = first;
            nodes[at].count = 1;
            return;
        }
        const auto children = static_cast<std::uint32_t>(nodes.size());
        nodes.resize(nodes.size() + 2);
        nodes[at].first = children;
        nodes[at].count = 0;
        const bool root = at == 0;
        self(self, children, root ? box(0, 1) : bounds, root ? leaves - 1 : leaves / 2, first);
        self(self, children + 1, root ? box(1, 2) : bounds, root ? 1 : leaves - leaves / 2,
             first + (root ? leaves - 1 : leaves / 2));
    };
    grow(grow, 0, box(0, 2), 9, 0);
    const std::vector<ClusterRef> refs(9, ClusterRef(ClusterRef::triangles, 0));
    const WideTree tree = widen(nodes, refs);
    REQUIRE(tree.nodes.size() == 2);
    CHECK(tree.expected_nodes == Approx(1 + 3.0 / 5));  // half areas: 3 of 5
}
