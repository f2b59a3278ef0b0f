// Visits the contents of grids along a ray, from near to far. Compiled for each instruction set.
#if defined(ETALON_GRID_VISIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_GRID_VISIT_INL_H
#undef ETALON_GRID_VISIT_INL_H
#else
#define ETALON_GRID_VISIT_INL_H
#endif

#include <hwy/highway.h>

#include "native_accel/grid/grid_traversal.h"
#include "native_accel/grid/packed_grid.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// An interval of a ray, in normalized space; empty if it ends before it begins.
struct RayInterval {
    HWY_INLINE RayInterval(float from, float to) : entry(from), exit(to) {}

    /// Clips the interval from tmin to tmax, both finite, to a box. The content of a grid lies
    /// further inside its box than the errors of this slab test.
    HWY_INLINE RayInterval(Float4 low, Float4 high, const GridRay& ray, float tmin, float tmax) {
        const Float4 a = (low - ray.origin) * ray.reciprocal;
        const Float4 b = (high - ray.origin) * ray.reciprocal;
        const Float4 never{0, 0, 0, std::numeric_limits<float>::infinity()};
        entry = std::max(tmin, -min_of_lanes(max(-a, -b) + never)[0]);
        exit = std::min(tmax, min_of_lanes(max(a, b) + never)[0]);
    }

    HWY_INLINE RayInterval(const Box3f& box, const GridRay& ray, float tmin, float tmax)
        : RayInterval(lanes(box.min, 0), lanes(box.max, 0), ray, tmin, tmax) {}

    HWY_INLINE bool empty() const { return !(entry <= exit); }

    float entry, exit;
};

/// Passes the packs of one cell after the other to test(packs, from, to, tmax). The ray is in the
/// cell from `from` to `to`, and hits beyond tmax are not needed. The test returns the tmax for
/// further cells. Counts every cell in test.counters.
template <class Pack, class Test>
class GridVisit {
  public:
    HWY_INLINE GridVisit(const PackedGrid<Pack>& grid, const GridRay& ray, const Test& test,
                         float tmax)
        : grid_(grid), ray_(ray), test_(test), tmax_(tmax) {}

    /// Visits the contents of the grid's box.
    HWY_INLINE void visit(const RayInterval& interval) {
        const GridCell& root = grid_.root();
        if (root.is_grid()) {
            traverse(grid_.node(root), interval);
        } else {
            test(root, interval);
        }
    }

  private:
    HWY_INLINE void visit(const GridCell& c, const RayInterval& interval) {
        if (!c.is_grid()) return test(c, interval);
        const GridNode& node = grid_.node(c);
        const RayInterval inside(node.low, node.high, ray_, interval.entry, interval.exit);
        if (!inside.empty()) traverse(node, inside);
    }

    HWY_INLINE void test(const GridCell& c, const RayInterval& interval) {
        tmax_ = test_(grid_.packs(c), interval.entry, interval.exit, tmax_);
    }

    void traverse(const GridNode& node, const RayInterval& interval) {
        auto [entry, end] = interval;
        GridTraversal traversal(node, ray_, entry);
        while (entry <= end) {
            test_.counters.cell();
            const GridCell c = grid_.cell(traversal.cell());
            const Float4 exit = traversal.exit();
            traversal.advance(exit);
            if (c.count != 0) {
                visit(c, {entry, std::min(exit[0], end)});
                end = std::min(end, tmax_);
            }
            entry = exit[0];
        }
    }

    const PackedGrid<Pack>& grid_;
    const GridRay& ray_;
    const Test& test_;
    float tmax_;
};

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
