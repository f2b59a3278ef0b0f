#include "embree_backend/nested_scene.h"

#include <algorithm>

#include "core/accel/tree/builder.h"
#include "core/intersect/normalized_ray.h"
#include "embree_backend/query.h"

namespace etalon {
namespace {

/// For rays from up to a hundred times the scene's size away: see margin_of() in
/// instance_bounds.cpp.
constexpr InstancePadding nest_padding = {NormalizedSpace::padding, 0x1p-36};
constexpr double largest_distance = 64;  ///< in the scene's normalized space

/// Largest size of a nested scene in the normalized space of the scene around it. Boxes are padded
/// by 2^-19 on each side, which is little for a box of 2^-14, and a space 64 times as fine is worth
/// the cost of entering it.
constexpr float small = 0x1p-14F, largest_nest = 0x1p-6F;
constexpr std::ptrdiff_t fewest = 64;

float extent(const Box3f& box) {
    const Vec3f size = box.size();
    return std::max({size.x, size.y, size.z});
}

bool is_small(const BoundedPrimitive& p) {
    constexpr auto padding = static_cast<float>(2 * NormalizedSpace::padding);
    return p.kind == instance_kind && extent(p.box()) < small + padding;
}

/// Collects the nodes of a tree that are so small, and have so many instances, that they should be
/// nested scenes.
class NestFinder {
  public:
    NestFinder(const BvhTree& tree, float least) : tree_(tree), least_(least) { visit(0); }

    std::vector<NestedSceneItems> take() { return std::move(found_); }

  private:
    void visit(std::size_t index) {
        const BvhNode& node = tree_.nodes[index];
        const auto begin = tree_.ids.begin() + first(index), end = tree_.ids.begin() + last(index);
        const float size = extent(node.box);
        if (end - begin < fewest || size < least_) return;
        if (size < largest_nest) {
            found_.push_back({node.box, {begin, end}});
            std::ranges::sort(found_.back().items);
        } else if (!node.is_leaf()) {
            visit(node.first);
            visit(node.first + 1);
        }
    }

    /// The range of a node's primitives, which are in the order of the leaves.
    std::uint32_t first(std::size_t index) const {
        while (!tree_.nodes[index].is_leaf()) index = tree_.nodes[index].first;
        return tree_.nodes[index].first;
    }
    std::uint32_t last(std::size_t index) const {
        while (!tree_.nodes[index].is_leaf()) index = tree_.nodes[index].first + 1;
        return tree_.nodes[index].first + tree_.nodes[index].count;
    }

    const BvhTree& tree_;
    const float least_;
    std::vector<NestedSceneItems> found_;
};

Box3 box_of(const Geometry& geometry, const NestedSceneData& shared,
            const std::vector<std::uint32_t>& items) {
    Box3 all;
    for (const std::uint32_t item : items)
        all.extendBy(shared.boxes[geometry.instance_number(item)]);
    return all;
}

}  // namespace

NestedSceneData::NestedSceneData(const Geometry& geometry, const Intersector& instances,
                                 const NormalizedSpace& space)
    : centre(space.centre()),
      scale(space.scale()),
      boxes(instance_bounds(geometry,
                            Box3(space.centre() - space.reach(), space.centre() + space.reach()),
                            NearRegion(), nest_padding)
                .boxes),
      objects(instances.object_spaces()) {}

bool NestedSceneData::hold_for(const Ray& ray) const {
    return max_abs(ray.origin - centre) * scale < largest_distance;
}

NestedScene::NestedScene(const EmbreeDevice& device, const Geometry& geometry,
                         const Intersector& instances, const std::vector<UserView>* objects,
                         const std::shared_ptr<const NestedSceneData>& shared,
                         std::vector<std::uint32_t> items)
    : instances_(instances),
      shared_(shared),
      items_(std::move(items)),
      space_(box_of(geometry, *shared, items_)),
      primitives_(geometry, instances, objects),
      embree_scene_(rtcNewScene(device.handle())) {
    device.check();
    std::vector<BoundedPrimitive> bounded;
    bounded.reserve(items_.size());
    for (const std::uint32_t item : items_) {
        const Box3& box = shared->boxes[geometry.instance_number(item)];
        bounded.emplace_back(space_.box(box), item, instance_kind);
    }
    primitives_.build(device, embree_scene_.get(), 0, space_, std::move(bounded), shared);
}

bool NestedScene::resolves(const Ray& ray) const {
    return shared_->hold_for(ray) && is_resolved(space_, ray);
}

void NestedScene::offer(const RayQuery& query, NearestHit& nearest) const {
    if (!resolves(query.ray)) {
        for (const std::uint32_t item : items_) instances_.offer_instance(item, query, nearest);
        return;
    }
    const auto local = normalized_ray(space_, query.ray);
    if (!local) return;
    RTCRayHit ray;
    set_ray(ray.ray, *local, local->tmin(query.ray.tmin), local->tmax(nearest.t));
    primitives_.intersect(query, *local, nearest, ray);
}

bool NestedScene::occludes(const RayQuery& query) const {
    if (!resolves(query.ray)) {
        return std::ranges::any_of(
            items_, [&](std::uint32_t item) { return instances_.instance_occludes(item, query); });
    }
    const auto local = normalized_ray(space_, query.ray);
    if (!local) return false;
    RTCRay ray;
    if (!set_occlusion_ray(ray, *local, local->tmin(query.ray.tmin), local->tmax(query.ray.tmax))) {
        return false;
    }
    primitives_.occluded(query, *local, ray);
    return ray.tfar < 0;
}

std::vector<NestedSceneItems> find_nested_scenes(const std::vector<BoundedPrimitive>& singles,
                                                 float least) {
    std::vector<BoundedPrimitive> smalls;
    std::ranges::copy_if(singles, std::back_inserter(smalls), is_small);
    if (std::ssize(smalls) < fewest) return {};
    return NestFinder(build_bvh(std::move(smalls)), least).take();
}

}  // namespace etalon
