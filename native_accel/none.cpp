#include "native_accel/none.h"

#include <algorithm>
#include <vector>

#include "core/intersect/kernels.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// Number of rays that are taken through the same steps together; what kernels need of them stays
/// in the fastest cache.
constexpr std::size_t group_size = 64;

/// The rays of a group that can be traced, with what kernels need of them.
struct QueryGroup {
    std::vector<RayQuery> queries;
    std::vector<NearestHit> nearest;
    std::vector<std::size_t> rays;  ///< the number of each one's ray

    void clear() {
        queries.clear();
        nearest.clear();
        rays.clear();
    }

    void add(const Ray& ray, std::size_t number) {
        if (!is_valid(ray)) return;
        queries.emplace_back(ray);
        nearest.emplace_back(ray.tmax);
        rays.push_back(number);
    }

    /// Removes the rays that have hit anything; calls f(number) for each.
    template <class F>
    void take_hit(const F& f) {
        for (std::size_t i = rays.size(); i-- > 0;) {
            if (nearest[i].primitive == no_index) continue;
            f(rays[i]);
            queries[i] = queries.back(), queries.pop_back();
            nearest[i] = nearest.back(), nearest.pop_back();
            rays[i] = rays.back(), rays.pop_back();
        }
    }
};

/// Calls f(group) for all rays, a group at a time.
template <class F>
void for_each_group(std::span<const Ray> rays, const F& f) {
    const DenormalsCount denormals_count;
    QueryGroup group;
    for (std::size_t first = 0; first < rays.size(); first += group_size) {
        group.clear();
        const std::size_t last = std::min(first + group_size, rays.size());
        for (std::size_t i = first; i < last; ++i) group.add(rays[i], i);
        f(group);
    }
}

}  // namespace

None::None(const Geometry& geometry) : Intersector(geometry, SceneBounds::none_bounded(geometry)) {}

std::size_t None::memory_bytes() const {
    return scene_bounds().unbounded.size() * sizeof(std::uint32_t);
}

void None::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    std::ranges::fill(hits, Hit{infinity, no_index});
    for_each_group(rays, [&](QueryGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            offer_to_all(geometry(), id, group.queries, group.nearest);
        }
        for (std::size_t i = 0; i < group.rays.size(); ++i) {
            hits[group.rays[i]] = {group.nearest[i].t, group.nearest[i].primitive};
        }
    });
}

void None::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    std::ranges::fill(blocked, std::uint8_t{0});
    for_each_group(rays, [&](QueryGroup& group) {
        for (const std::uint32_t id : scene_bounds().unbounded) {
            if (!offer_to_all(geometry(), id, group.queries, group.nearest)) continue;
            group.take_hit([&](std::size_t ray) { blocked[ray] = 1; });
        }
    });
}

}  // namespace etalon
