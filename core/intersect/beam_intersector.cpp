#include "core/intersect/beam_intersector.h"

#include <algorithm>
#include <array>

#include "core/intersect/group_kernels.h"
#include "core/intersect/kernels.h"
#include "core/intersect/ray_groups.h"
#include "core/numerics/denormals.h"

namespace etalon {
namespace {

/// The numbers of primitives that a group may meet.
using Near = std::array<std::uint32_t, BeamIntersector::most_primitives>;

/// Whether to test a group against so many primitives costs less than the way of each ray through
/// a tree: the fewer rays share a test, the fewer tests are worth it.
bool is_worthwhile(std::size_t primitives, std::size_t rays) {
    return primitives <= 1 + rays / 4;
}

/// Answers of a backend for the rays of a group.
template <class Answer>
class BackendAnswers {
  public:
    /// `ask` takes rays and where their answers go.
    template <class Ask>
    BackendAnswers(const RayGroup& group, const Ask& ask) {
        std::array<Ray, RayGroup::most> rays;
        for (std::size_t i = 0; i < group.count; ++i) rays[i] = *group.rays[i];
        ask(std::span(rays).first(group.count), std::span(answers_).first(group.count));
    }

    const Answer& operator[](std::size_t i) const { return answers_[i]; }

  private:
    std::array<Answer, RayGroup::most> answers_;
};

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
    }
}

/// Calls offer(group, near) with the few primitives that rays of a group may meet, or
/// ask_backend(group) where they are many.
template <class Offer, class AskBackend>
void BeamIntersector::for_each_beam(std::span<const Ray> rays, const Offer& offer,
                                    const AskBackend& ask_backend) const {
    const DenormalsCount denormals_count;
    for_each_group(rays, [&](RayGroup& group) {
        const RayBeam beam(group);
        if (!beam.goes_one_way()) return ask_backend(group);
        Near near;
        const std::size_t count = beam.find_near(boxes_, near.data());
        if (!is_worthwhile(count, group.count)) return ask_backend(group);
        offer(group, std::span(near).first(count));
    });
}

/// Rays of a batch are alike in that hint. That shadow rays of neighbours go to the same lights is
/// likely without it.
void BeamIntersector::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (!has_beams_ || rays.empty() || !rays[0].coherent()) return backend_.closest(rays, hits);
    std::ranges::fill(hits, Hit{infinity, no_index});
    const auto hit_of = [&](const Ray* ray) -> Hit& { return hits[ray - rays.data()]; };
    for_each_beam(
        rays,
        [&](RayGroup& group, std::span<const std::uint32_t> near) {
            for (const std::uint32_t i : near) offer_to_group(geometry_, primitives_[i], group);
            for (std::size_t i = 0; i < group.count; ++i) hit_of(group.rays[i]) = group.hit(i);
        },
        [&](const RayGroup& group) {
            const BackendAnswers<Hit> answers(
                group, [&](auto some, auto to) { backend_.closest(some, to); });
            for (std::size_t i = 0; i < group.count; ++i) hit_of(group.rays[i]) = answers[i];
        });
}

void BeamIntersector::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    if (!has_beams_) return backend_.occluded(rays, blocked);
    std::ranges::fill(blocked, std::uint8_t{0});
    const auto is_blocked = [&](const Ray* ray) -> std::uint8_t& {
        return blocked[ray - rays.data()];
    };
    for_each_beam(
        rays,
        [&](RayGroup& group, std::span<const std::uint32_t> near) {
            for (const std::uint32_t i : near) {
                if (offer_to_group(geometry_, primitives_[i], group)) {
                    group.remove_hit([&](const Ray* ray) { is_blocked(ray) = 1; });
                }
            }
        },
        [&](const RayGroup& group) {
            const BackendAnswers<std::uint8_t> answers(
                group, [&](auto some, auto to) { backend_.occluded(some, to); });
            for (std::size_t i = 0; i < group.count; ++i) is_blocked(group.rays[i]) = answers[i];
        });
}

}  // namespace etalon
