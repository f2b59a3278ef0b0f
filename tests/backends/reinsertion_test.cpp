// Properties of trees whose subtrees were moved.
#include "core/accel/tree/reinsertion.h"

#include "core/accel/tree/linked_tree.h"
#include "tests/backends/trees.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double surface(const BvhTree& tree, const Primitives& primitives) {
    return Inspection(tree, primitives).surface;
}

}  // namespace

TEST_CASE("Given any tree, moving its subtrees keeps it sound and makes it no larger") {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 9U, 100U, 4097U}) {
        for (const Cast cast : all_casts()) {
            CAPTURE(count, reinterpret_cast<const void*>(cast));
            const Primitives primitives = cast(count);
            const BvhTree tree = build_bvh(primitives), moved = reinserted(tree);
            require_sound(moved, primitives);
            CHECK(surface(moved, primitives) <= surface(tree, primitives));
        }
    }
}

TEST_CASE("Given boxes of similar sizes, their tree is returned as it was") {
    const BvhTree tree = build_bvh(scattered(10'000));
    CHECK(same(reinserted(tree), tree));
}

TEST_CASE("Given a linked tree of any size, nothing moved gives the same tree") {
    const BvhTree tree = build_bvh(of_all_kinds(1000));
    for (const std::size_t most : {2U, 3U, 4U, 101U, 100'000U}) {
        CAPTURE(most);
        const LinkedTree top(tree, most);
        CHECK(top.nodes().size() <= std::max<std::size_t>(most, 1));
        CHECK(same(top.whole(), tree));
    }
}

TEST_CASE("Given a node taken out and put back, a linked tree is the same but for its side") {
    const Primitives primitives = nested(500);
    const BvhTree tree = build_bvh(primitives);
    LinkedTree top(tree, 200);
    for (LinkedTree::Index node = 0; node < top.nodes().size(); ++node) {
        const LinkedTree::Index parent = top[node].parent;
        if (parent == LinkedTree::none || top[parent].parent == LinkedTree::none) continue;
        const int height = top[0].height;
        const double before = top.surface();
        const LinkedTree::Index sibling = top.detach(node);
        CHECK(top.may_attach(node, sibling));
        top.attach(node, sibling);
        CHECK(top.surface() == before);
        CHECK(top[0].height == height);
    }
    require_sound(top.whole(), primitives);
}

TEST_CASE("Given nodes put ever deeper, no leaf gets deeper than a traversal's stack allows") {
    const Primitives primitives = scattered(5000);
    const BvhTree tree = build_bvh(primitives);
    LinkedTree top(tree, 10'000);
    LinkedTree::Index deepest = 1;
    for (LinkedTree::Index node = 1; node < top.nodes().size(); ++node) {
        const LinkedTree::Index parent = top[node].parent;
        if (!top[node].is_lowest() || node == deepest || top[parent].parent == LinkedTree::none) {
            continue;
        }
        const LinkedTree::Index sibling = top.detach(node);
        while (!top[deepest].is_lowest()) deepest = top[deepest].children[0];
        top.attach(node, top.may_attach(node, deepest) ? deepest : sibling);
        REQUIRE(top[0].height <= bvh_max_depth);
    }
    CHECK(top[0].height == bvh_max_depth);
    require_sound(top.whole(), primitives);
}
