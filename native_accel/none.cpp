#include "native_accel/none.h"

#include <algorithm>
#include <array>

#include "core/intersect/group_kernels.h"
#include "core/intersect/kernels.h"
#include "core/intersect/ray_beam.h"
#include "core/intersect/ray_columns.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Whether all rays are common ones of the same dominant axis.
bool are_alike(const RayColumns& rays) {
    std::uint64_t common = ~std::uint64_t{0}, differences = 0;
    for (std::size_t i = 0; i < rays.count; ++i) {
        common &= rays.common[i];
        differences |= rays.dominants[i] ^ rays.dominants[0];
    }
    return common != 0 && differences == 0;
}

/// Calls trace(group) for all rays, a group of one dominant axis at a time.
template <class Trace>
void for_each_group(std::span<const Ray> rays, const Trace& trace) {
    const DenormalsCount denormals_count;
    std::array<RayGroup, 3> groups;
    for (int axis = 0; axis < 3; ++axis) groups[axis].dominant = axis;
    RayGroup alike;
    const auto finish = [&](RayGroup& group) {
        trace(group);
        group.count = 0;
    };
    const auto add = [&](const Ray& ray, const Vec3& direction, std::size_t dominant) {
        RayGroup& group = groups[dominant];
        group.add(ray, direction);
        if (group.is_full()) finish(group);
    };
    for (std::size_t first = 0; first < rays.size(); first += RayColumns::most) {
        const std::span chunk =
            rays.subspan(first, std::min(RayColumns::most, rays.size() - first));
        const RayColumns columns(chunk);
        if (are_alike(columns)) {
            alike.set(chunk, columns);
            trace(alike);
            continue;
        }
        for (std::size_t i = 0; i < chunk.size(); ++i) {
            const Ray& ray = chunk[i];
            if (columns.common[i] != 0) {
                add(ray, ray.direction, columns.dominants[i]);
            } else if (is_valid(ray)) {
                const RayQuery query(ray);
                add(ray, query.ray.direction, query.kz);
            }
        }
    }
    for (RayGroup& group : groups) finish(group);
}

}  // namespace

None::None(const Geometry& geometry) : Intersector(geometry, SceneBounds::none_bounded(geometry)) {
    build_objects<None>();
    boxes_.reserve(geometry.primitives.size());
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        boxes_.push_back(whole_bounds(geometry, id));
    }
}

/// Calls visit(item) for the instances, as long as it returns true. Returns whether it always did.
template <class Visit>
bool None::for_each_instance(const Visit& visit) const {
    const auto first = static_cast<std::uint32_t>(geometry().primitives.size());
    for (std::uint32_t item = first; item < geometry().item_count(); ++item) {
        if (!visit(item)) return false;
    }
    return true;
}

std::size_t None::own_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t) + boxes_.size() * sizeof(Box3);
}

/// Calls visit(id) for the primitives that a ray of the group may meet.
template <class Visit>
void None::for_each_near(const RayGroup& group, const Visit& visit) const {
    if (group.count == 0) return;
    const RayBeam beam(group);
    for (const std::uint32_t id : scene_bounds().unbounded) {
        if (!beam.surely_misses(boxes_[id])) visit(id);
    }
}

void None::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    std::ranges::fill(hits, Hit{infinity, no_index});
    for_each_group(rays, [&](RayGroup& group) {
        for_each_near(group, [&](std::uint32_t id) { offer_to_group(geometry(), id, group); });
        const bool has_instances = !geometry().instances.empty();
        for (std::size_t i = 0; i < group.count; ++i) {
            const Hit hit = group.hit(i);
            hits[group.rays[i] - rays.data()] =
                has_instances ? with_instances(*group.rays[i], hit) : hit;
        }
    });
}

/// Returns the nearer of the hit on a primitive that is the nearest one, and those on instances.
Hit None::with_instances(const Ray& ray, const Hit& hit) const {
    const RayQuery query(ray);
    NearestHit nearest(hit.t);
    nearest.item = hit.primitive;
    for_each_instance([&](std::uint32_t item) {
        offer_instance(item, query, nearest);
        return true;
    });
    return hit_of(nearest);
}

bool None::instances_occlude(const Ray& ray) const {
    const RayQuery query(ray);
    return !for_each_instance([&](std::uint32_t item) { return !instance_occludes(item, query); });
}

void None::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    std::ranges::fill(blocked, std::uint8_t{0});
    for_each_group(rays, [&](RayGroup& group) {
        for_each_near(group, [&](std::uint32_t id) {
            if (!offer_to_group(geometry(), id, group)) return;
            for (std::size_t i = group.count; i-- > 0;) {
                if (group.primitives[i] == RayGroup::none) continue;
                blocked[group.rays[i] - rays.data()] = 1;
                group.remove(i);
            }
        });
        if (geometry().instances.empty()) return;
        for (std::size_t i = 0; i < group.count; ++i) {
            blocked[group.rays[i] - rays.data()] = instances_occlude(*group.rays[i]) ? 1 : 0;
        }
    });
}

}  // namespace etalon
