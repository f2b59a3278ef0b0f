// How a ray visits what lies in grids, from near to far.
#pragma once

#include <bit>

#include "native_accel/grid/mailbox.h"
#include "native_accel/grid/packed_grid.h"
#include "native_accel/grid/walk.h"

namespace etalon {

template <class Pack, class Filter, class Offer>
class GridVisit {
  public:
    GridVisit(const PackedGrid<Pack>& grid, const GridRay& ray, const Filter& filter,
              const Offer& offer, float tmax)
        : grid_(grid), ray_(ray), filter_(filter), offer_(offer), tmax_(tmax) {}

    /// What the ray could hit in a cell that it is in from `entry` to `exit`.
    void visit(const GridCell& c, float entry, float exit) {
        if (c.is_grid()) {
            walk(grid_.node(c.first), entry, std::min(exit, tmax_));
        } else {
            test(c);
        }
    }

  private:
    /// A cell with something in it, on the way.
    struct Passage {
        GridCell cell;
        float entry, exit;
    };

    /// Goes some cells ahead before it visits them, so that memory is asked for the contents of
    /// several at once: at first one, as a surface most often is hit in the first, then ever more.
    void walk(const GridNode& node, float entry, float end) {
        constexpr std::size_t most = 8;
        GridWalk walk(node, ray_, entry);
        std::array<Passage, most> passages;
        for (std::size_t ahead = 1; entry <= end; ahead = std::min(2 * ahead, most)) {
            std::size_t count = 0;
            do {
                const GridCell c = grid_.cell(walk.cell());
                const Float4 exit = walk.exit();
                passages[count] = {c, entry, exit[0]};
                count += c.count != 0 ? 1 : 0;
                entry = exit[0];
                walk.advance(exit);
            } while (entry <= end && count < ahead);
            for (std::size_t i = 0; i < count; ++i) grid_.prefetch(passages[i].cell);
            for (std::size_t i = 0; i < count; ++i) {
                const auto& [c, from, to] = passages[i];
                if (from > end) return;
                visit(c, from, std::min(to, end));
                end = std::min(end, tmax_);
            }
        }
    }

    void test(const GridCell& c) {
        for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
            unsigned candidates = bits(filter_.candidates(grid_.packed(i), tmax_));
            for (; candidates != 0; candidates &= candidates - 1) {
                const std::uint32_t id = grid_.id(i, std::countr_zero(candidates));
                if (mailbox_.add(id)) tmax_ = offer_(id);
            }
        }
    }

    const PackedGrid<Pack>& grid_;
    const GridRay& ray_;
    const Filter filter_;
    const Offer& offer_;
    float tmax_;
    Mailbox mailbox_;
};

/// Calls offer(id) for all that the ray could hit from tmin to tmax, in the frame; both finite. It
/// returns the tmax from then on. The grid's box reaches further than the errors of this slab test.
template <class Filter, class Pack, class Offer>
void visit(const PackedGrid<Pack>& grid, const FrameRay& local, const GridRay& ray, float tmin,
           float tmax, const Offer& offer) {
    if (grid.empty()) return;
    const Float4 a = (lanes(grid.box().min, 0) - ray.origin) * ray.reciprocal;
    const Float4 b = (lanes(grid.box().max, 0) - ray.origin) * ray.reciprocal;
    const Float4 never{0, 0, 0, std::numeric_limits<float>::infinity()};
    const float entry = std::max(tmin, -min_of_lanes(max(-a, -b) + never)[0]);
    const float exit = std::min(tmax, min_of_lanes(max(a, b) + never)[0]);
    if (!(entry <= exit)) return;
    const Filter filter(local);
    GridVisit<Pack, Filter, Offer>(grid, ray, filter, offer, tmax).visit(grid.root(), entry, exit);
}

}  // namespace etalon
