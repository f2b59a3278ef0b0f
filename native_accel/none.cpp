#include "native_accel/none.h"

#include <algorithm>
#include <array>

#include "core/intersect/group_kernels.h"
#include "core/intersect/ray_columns.h"
#include "core/intersect/rescaled_ray.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Calls trace(group) for all rays, a group of one dominant axis at a time, and alone(i) for those
/// of an extreme direction.
template <class Trace, class Alone>
void for_each_group(std::span<const Ray> rays, const Trace& trace, const Alone& alone) {
    const DenormalsCount denormals_count;
    std::array<RayGroup, 3> groups;
    for (int axis = 0; axis < 3; ++axis) groups[axis].dominant = axis;
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
        for (std::size_t i = 0; i < chunk.size(); ++i) {
            const Ray& ray = chunk[i];
            if (columns.common[i] != 0) {
                add(ray, ray.direction, columns.dominants[i]);
            } else if (has_extreme_direction(ray)) {
                alone(first + i);
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
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

void None::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    constexpr Hit nothing{infinity, no_index};
    std::ranges::fill(hits, nothing);
    const auto trace = [&](RayGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            offer_to_group(geometry(), id, group);
        }
        const bool has_instances = !geometry().instances.empty();
        for (std::size_t i = 0; i < group.count; ++i) {
            const Hit hit = group.hit(i);
            hits[group.rays[i] - rays.data()] =
                has_instances ? with_instances(*group.rays[i], hit) : hit;
        }
    };
    for_each_group(rays, trace,
                   [&](std::size_t i) { hits[i] = closest(rays[i]).value_or(nothing); });
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
    const auto trace = [&](RayGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            if (!offer_to_group(geometry(), id, group)) continue;
            for (std::size_t i = group.count; i-- > 0;) {
                if (group.primitives[i] == RayGroup::none) continue;
                blocked[group.rays[i] - rays.data()] = 1;
                group.remove(i);
            }
        }
        if (geometry().instances.empty()) return;
        for (std::size_t i = 0; i < group.count; ++i) {
            blocked[group.rays[i] - rays.data()] = instances_occlude(*group.rays[i]) ? 1 : 0;
        }
    };
    for_each_group(rays, trace, [&](std::size_t i) { blocked[i] = occluded(rays[i]) ? 1 : 0; });
}

}  // namespace etalon
