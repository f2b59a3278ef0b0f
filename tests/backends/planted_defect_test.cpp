// A defect planted in the tree shared by bvh, grid and embree is found by comparing with
// `embree-user` and `none`, which agree with each other.
#include <algorithm>

#include "core/accel/tree/scene_tree.h"
#include "native_accel/bvh/traversal.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// The backend `bvh` over a tree that a test has changed.
class BvhOfTree final : public Intersector {
  public:
    BvhOfTree(const Geometry& geometry, BvhTree tree) : Intersector(geometry) {
        std::vector<Range> ranges;
        for (BvhNode& node : tree.nodes) {
            if (!node.is_leaf()) continue;
            ranges.push_back({node.first, node.count});
            node.first = static_cast<std::uint32_t>(ranges.size() - 1);
        }
        const std::vector<ClusterRef> refs = cluster_refs(geometry, tree.ids, ranges);
        clusters_ = Clusters(geometry, scene_bounds().space, tree.ids, ranges, refs);
        tree_ = widen(tree.nodes, refs);
    }

  protected:
    std::size_t own_bytes() const override { return clusters_.memory_bytes(); }
    void closest_bounded(const RayQuery& query, const NormalizedRay& local,
                         NearestHit& nearest) const override {
        walk_.closest({geometry(), scene_bounds(), tree_, clusters_, *this}, query, local, nearest);
    }
    bool occluded_bounded(const RayQuery& query, const NormalizedRay& local) const override {
        return walk_.occluded({geometry(), scene_bounds(), tree_, clusters_, *this}, query, local);
    }

  private:
    Clusters clusters_;
    WideTree tree_;
    const BvhTraversal walk_ = bvh_traversal();
};

BvhTree tree_of(const Geometry& geometry, std::vector<BoundedPrimitive> primitives) {
    return build_scene_bvh(geometry, SceneBounds::of(geometry).space, std::move(primitives));
}

std::vector<std::size_t> leaves_of(const BvhTree& tree) {
    std::vector<std::size_t> leaves;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].is_leaf()) leaves.push_back(i);
    }
    return leaves;
}

/// Rays, and the hits of the two backends that do not use the shared tree.
class ReferenceHits {
  public:
    explicit ReferenceHits(const Scene& scene) : scene_(scene) {
        const auto none = backend_named("none").build(scene.geometry);
        const auto embree_user = backend_named("embree-user").build(scene.geometry);
        Random random(21);
        rays_ = make_rays(scene, 4000, random);
        for (const Ray& ray : rays_) {
            hits_.push_back(embree_user->closest(ray));
            disagreements_ += !difference(*none, ray, hits_.back()).empty();
        }
    }

    /// The number of rays on which the two differ.
    std::size_t disagreements() const { return disagreements_; }

    /// Returns whether any hit of a backend over this tree differs.
    bool differ_from(const BvhTree& tree) const {
        const BvhOfTree bvh(scene_.geometry, tree);
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            if (!difference(bvh, rays_[i], hits_[i]).empty()) return true;
        }
        return false;
    }

  private:
    const Scene& scene_;
    std::vector<Ray> rays_;
    std::vector<std::optional<Hit>> hits_;
    std::size_t disagreements_ = 0;
};

/// The number of leaves at which a defect, planted there alone, is found.
template <class Defect>
std::size_t found_defects(const ReferenceHits& reference, const BvhTree& whole,
                          const Defect& plant) {
    std::size_t count = 0;
    for (const std::size_t leaf : leaves_of(whole)) {
        BvhTree tree = whole;
        plant(tree, tree.nodes[leaf]);
        count += reference.differ_from(tree);
    }
    return count;
}

/// Replaces the leaf's primitives by those of another leaf, so that they are in no leaf.
void drop(const BvhTree& tree, BvhNode& leaf) {
    const auto other = std::find_if(tree.nodes.begin(), tree.nodes.end(),
                                    [&](const BvhNode& n) { return n.is_leaf() && &n != &leaf; });
    leaf.first = other->first;
    leaf.count = other->count;
}

/// Shrinks a leaf's box to half its size.
void shrink(const BvhTree&, BvhNode& leaf) {
    const Vec3f margin = leaf.box.size() * 0.25F;
    leaf.box.min += margin;
    leaf.box.max -= margin;
}

constexpr const char* families[] = {"triangles", "spheres", "closed_mesh"};

}  // namespace

TEST_CASE("Given a tree without a defect, embree-user and none find the same hits", "[backends]") {
    for (const char* family : families) {
        INFO(family);
        const Scene scene = make_scene(family, 300);
        const ReferenceHits reference(scene);
        CHECK(reference.disagreements() == 0);
        CHECK_FALSE(reference.differ_from(
            tree_of(scene.geometry, SceneBounds::of(scene.geometry).bounded)));
    }
}

TEST_CASE("Given a tree that has lost a leaf, embree-user and none find other hits", "[backends]") {
    for (const char* family : families) {
        INFO(family);
        const Scene scene = make_scene(family, 300);
        const BvhTree tree = tree_of(scene.geometry, SceneBounds::of(scene.geometry).bounded);
        CHECK(found_defects(ReferenceHits(scene), tree, drop) == leaves_of(tree).size());
    }
}

TEST_CASE("Given a tree with a box that is too small, embree-user and none find other hits",
          "[backends]") {
    for (const char* family : families) {
        INFO(family);
        const Scene scene = make_scene(family, 300);
        const BvhTree tree = tree_of(scene.geometry, SceneBounds::of(scene.geometry).bounded);
        CHECK(found_defects(ReferenceHits(scene), tree, shrink) == leaves_of(tree).size());
    }
}

TEST_CASE("Given a tree built without a primitive, embree-user and none find other hits",
          "[backends]") {
    const Scene scene = make_scene("triangles", 100);
    const ReferenceHits reference(scene);
    const std::vector<BoundedPrimitive> all = SceneBounds::of(scene.geometry).bounded;
    for (std::size_t lost = 0; lost < all.size(); ++lost) {
        INFO("without " << lost);
        std::vector<BoundedPrimitive> others = all;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(lost));
        CHECK(reference.differ_from(tree_of(scene.geometry, others)));
    }
}
