#include "core/intersect/shapes/polygon_outline.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/shapes/polygon_outline.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef ETALON_POLYGON_OUTLINE_ONCE
#define ETALON_POLYGON_OUTLINE_ONCE
namespace etalon {

/// Number of corners that one call of the vector code handles.
constexpr std::size_t word_bits = 64, words = 4, corners_at_once = words * word_bits;

/// One bit for each corner: whether its sheared y is surely above zero, and surely below.
struct SureSides {
    std::array<std::uint64_t, words> above, below;
};

/// The sheared y of a corner, y_scale Y - z_scale Z + constant. Its sign is sure beyond
/// `error_bound`.
struct SideFilter {
    SideFilter(const Box3& box, const RayQuery& q);

    double y_scale, z_scale, constant, error_bound;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Handles `count` <= corners_at_once corners, rounded up to a multiple of the lanes.
SureSides sure_sides(const double* ys, const double* zs, std::size_t count, const SideFilter& f) {
    using Tag = hn::CappedTag<double, CornerColumns::lanes>;
    const Tag tag;
    const auto y_scale = hn::Set(tag, f.y_scale), z_scale = hn::Set(tag, f.z_scale);
    const auto constant = hn::Set(tag, f.constant);
    const auto bound = hn::Set(tag, f.error_bound), minus_bound = hn::Set(tag, -f.error_bound);
    const auto bits = [](auto mask) HWY_ATTR {
        std::uint8_t byte = 0;
        hn::StoreMaskBits(Tag(), mask, &byte);
        return static_cast<std::uint64_t>(byte);
    };
    SureSides sides{};
    for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
        const auto depth = hn::NegMulAdd(z_scale, hn::LoadU(tag, zs + i), constant);
        const auto y = hn::MulAdd(y_scale, hn::LoadU(tag, ys + i), depth);
        sides.above[i / word_bits] |= bits(hn::Gt(y, bound)) << i % word_bits;
        sides.below[i / word_bits] |= bits(hn::Lt(y, minus_bound)) << i % word_bits;
    }
    return sides;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(sure_sides);

/// With M = |dz| (|Y| + |oy|) + |dy| (|Z| + |oz|) for the largest |Y| and |Z|: the constant's two
/// products and their difference are off by 2 u M in sum, the two products with the corner by u M,
/// and the sums of two and of all three terms by u M each, to first order, with or without fused
/// multiplication. Twice that also covers the higher orders. Below 2^-1000 products that underflow
/// could matter. Where M is not finite every corner is uncertain.
SideFilter::SideFilter(const Box3& box, const RayQuery& q) {
    const Vec3 &o = q.ray.origin, reach(std::max(std::abs(box.min.x), std::abs(box.max.x)),
                                        std::max(std::abs(box.min.y), std::abs(box.max.y)),
                                        std::max(std::abs(box.min.z), std::abs(box.max.z)));
    y_scale = q.dz;
    z_scale = q.dy;
    constant = q.dy * o[q.kz] - q.dz * o[q.ky];
    const double terms = std::abs(q.dz) * (reach[q.ky] + std::abs(o[q.ky])) +
                         std::abs(q.dy) * (reach[q.kz] + std::abs(o[q.kz]));
    error_bound = 10 * unit_roundoff * terms + 0x1p-1000;
}

namespace {

/// Makes the decisions of covers() for single corners and edges, in the same way. Corners are
/// numbered as in the columns: number 0 is the last corner.
class CrossingCounter {
  public:
    CrossingCounter(std::span<const Vec3> p, const RayQuery& q) : p_(p), q_(q) {}

    bool is_above(std::size_t i) const { return corner(i).y > 0; }

    /// Counts the edge from i - 1 to i, which crosses the x axis.
    void cross(std::size_t i) {
        const OutlineCorner a = corner(i - 1), b = corner(i);
        const double side = edge_side(a, b, q_);
        on_outline_ |= side == 0;
        inside_ ^= (side > 0) == (b.y > 0);
    }

    /// Counts the edge from i - 1 to i, which does not cross the x axis, but may end on it.
    void touch(std::size_t i) {
        const OutlineCorner a = corner(i - 1), b = corner(i);
        on_outline_ |= b.y == 0 && (b.x == 0 || (a.y == 0 && (a.x > 0) != (b.x > 0)));
    }

    bool covers() const { return on_outline_ ? !is_edge_on(p_, q_) : inside_; }

  private:
    OutlineCorner corner(std::size_t i) const { return {i == 0 ? p_.back() : p_[i - 1], q_}; }

    std::span<const Vec3> p_;
    const RayQuery& q_;
    bool inside_ = false, on_outline_ = false;
};

template <class Visit>
void for_each_bit(std::uint64_t bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

bool is_edge_on(std::span<const Vec3> p, const RayQuery& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (exact_edge_function(p[i], p[(i + 1) % p.size()], q) != 0) return false;
    }
    return true;
}

bool covers_by_columns(const StoredPolygon& p, const RayQuery& q) {
    const std::size_t count = p.corners.size() + 1;
    const SideFilter filter(p.facts.box, q);
    const double *ys = p.columns.along(q.ky), *zs = p.columns.along(q.kz);
    CrossingCounter counter(p.corners, q);
    std::uint64_t previous = 0, edges = ~1ULL;  // none ends at number 0
    SureSides sides;
    for (std::size_t first = 0, word = words; first < count; first += word_bits, ++word) {
        const std::size_t left = count - first;
        if (word == words) {
            sides = HWY_DYNAMIC_DISPATCH(sure_sides)(ys + first, zs + first,
                                                     std::min(left, corners_at_once), filter);
            word = 0;
        }
        if (left < word_bits) edges &= (1ULL << left) - 1;
        std::uint64_t above = sides.above[word];
        const std::uint64_t undecided = ~(above | sides.below[word]) & (edges | (first == 0));
        for_each_bit(undecided, [&](std::size_t i) {
            if (counter.is_above(first + i)) above |= 1ULL << i;
        });
        const std::uint64_t crossing = (above ^ (above << 1 | previous)) & edges;
        for_each_bit(crossing, [&](std::size_t i) { counter.cross(first + i); });
        for_each_bit(undecided & edges & ~crossing,
                     [&](std::size_t i) { counter.touch(first + i); });
        previous = above >> (word_bits - 1);
        edges = ~0ULL;
    }
    return counter.covers();
}

}  // namespace etalon
#endif
