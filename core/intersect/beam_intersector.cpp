#include "core/intersect/beam_intersector.h"

#include <algorithm>
#include <array>

#include "core/intersect/group_kernels.h"
#include "core/intersect/kernels.h"
#include "core/intersect/ray_groups.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// What it costs to test a group against a primitive: 1 where rays share the test.
constexpr std::uint8_t cost_one_by_one = 4;

/// Whether tests of that cost take less than the way of each ray through a tree: the fewer rays
/// share them, the less they are worth.
bool is_worthwhile(std::size_t cost, std::size_t rays) {
    return cost <= 1 + rays / 4;
}

/// So many rays of a batch, of which no beam is next to few primitives, say that others will be no
/// better.
constexpr std::size_t probed = 2 * RayGroup::most;

/// Asks a backend, ask(rays, answers), for those of `rays` that are in the group.
template <class Answer, class Ask>
void ask_for_group(const RayGroup& group, std::span<const Ray> rays, std::span<Answer> answers,
                   const Ask& ask) {
    if (group.count == rays.size()) return ask(rays, answers);
    std::array<Ray, RayGroup::most> some;
    std::array<Answer, RayGroup::most> found;
    for (std::size_t i = 0; i < group.count; ++i) some[i] = *group.rays[i];
    ask(std::span<const Ray>(some).first(group.count), std::span(found).first(group.count));
    for (std::size_t i = 0; i < group.count; ++i) answers[group.rays[i] - rays.data()] = found[i];
}

}  // namespace

BeamIntersector::BeamIntersector(const Geometry& geometry, const BatchIntersector& backend,
                                 bool is_exact)
    : geometry_(geometry),
      backend_(backend),
      has_beams_(is_exact && geometry.instances.empty() &&
                 geometry.primitives.size() <= most_primitives) {
    if (!has_beams_) return;
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        const Box3 box = whole_bounds(geometry, id);
        if (box.isEmpty()) continue;
        boxes_.add(box);
        primitives_.push_back(id);
        costs_.push_back(has_group_kernel(geometry.primitives[id]) ? 1 : cost_one_by_one);
    }
}

/// Finds the primitives that rays of a group may meet. Returns nothing where they are many.
std::optional<std::span<const std::uint32_t>> BeamIntersector::find_few(const RayGroup& group,
                                                                        Near& near) const {
    const RayBeam beam(group);
    if (!beam.goes_one_way()) return std::nullopt;
    const auto found = std::span(near).first(beam.find_near(boxes_, near.data()));
    std::size_t cost = 0;
    for (const std::uint32_t i : found) cost += costs_[i];
    if (!is_worthwhile(cost, group.count)) return std::nullopt;
    return found;
}

/// Sets the answers by offer(group, near), with the few primitives that rays of a group may meet,
/// or by ask(rays, answers), which asks the backend.
template <class Answer, class Offer, class Ask>
void BeamIntersector::answer_all(std::span<const Ray> rays, std::span<Answer> answers,
                                 const Offer& offer, const Ask& ask) const {
    const DenormalsCount denormals_count;
    bool any_few = false;
    for (std::size_t first = 0; first < rays.size(); first += RayGroup::most) {
        if (first == probed && !any_few) return ask(rays.subspan(first), answers.subspan(first));
        const std::size_t count = std::min(RayGroup::most, rays.size() - first);
        const auto chunk = rays.subspan(first, count);
        for_each_group(chunk, [&](RayGroup& group) {
            Near near;
            if (const auto few = find_few(group, near)) {
                offer(group, *few);
                any_few = true;
            } else {
                ask_for_group(group, chunk, answers.subspan(first, count), ask);
            }
        });
    }
}

/// Rays of a batch are alike in that hint. That shadow rays of neighbours go to the same lights is
/// likely without it.
void BeamIntersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (!has_beams_ || rays.empty() || !rays[0].coherent()) return backend_.closest(rays, hits);
    std::ranges::fill(hits, Hit{infinity, no_index});
    const auto offer = [&](RayGroup& group, std::span<const std::uint32_t> near) {
        for (const std::uint32_t i : near) offer_to_group(geometry_, primitives_[i], group);
        for (std::size_t i = 0; i < group.count; ++i) {
            hits[group.rays[i] - rays.data()] = group.hit(i);
        }
    };
    answer_all(rays, hits, offer, [&](auto some, auto to) { backend_.closest(some, to); });
}

void BeamIntersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    if (!has_beams_) return backend_.occluded(rays, blocked);
    std::ranges::fill(blocked, std::uint8_t{0});
    const auto offer = [&](RayGroup& group, std::span<const std::uint32_t> near) {
        for (const std::uint32_t i : near) {
            if (!offer_to_group(geometry_, primitives_[i], group)) continue;
            group.remove_hit([&](const Ray* ray) { blocked[ray - rays.data()] = 1; });
        }
    };
    answer_all(rays, blocked, offer, [&](auto some, auto to) { backend_.occluded(some, to); });
}

}  // namespace etalon
