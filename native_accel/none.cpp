#include "native_accel/none.h"

#include <algorithm>
#include <array>

#include "core/intersect/group_kernels.h"
#include "core/intersect/ray_columns.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Calls trace(group) for all rays, a group of one dominant axis at a time.
template <class Trace>
void for_each_group(std::span<const Ray> rays, const Trace& trace) {
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
            } else if (is_valid(ray)) {
                const RayQuery query(ray);
                add(ray, query.ray.direction, query.kz);
            }
        }
    }
    for (RayGroup& group : groups) finish(group);
}

}  // namespace

None::None(const Geometry& geometry) : Intersector(geometry, SceneBounds::none_bounded(geometry)) {}

std::size_t None::memory_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

void None::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    std::ranges::fill(hits, Hit{infinity, no_index});
    for_each_group(rays, [&](RayGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            offer_to_group(geometry(), id, group);
        }
        for (std::size_t i = 0; i < group.count; ++i) {
            hits[group.rays[i] - rays.data()] = group.hit(i);
        }
    });
}

void None::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    std::ranges::fill(blocked, std::uint8_t{0});
    for_each_group(rays, [&](RayGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            if (!offer_to_group(geometry(), id, group)) continue;
            for (std::size_t i = group.count; i-- > 0;) {
                if (group.primitives[i] == RayGroup::none) continue;
                blocked[group.rays[i] - rays.data()] = 1;
                group.remove(i);
            }
        }
    });
}

}  // namespace etalon
