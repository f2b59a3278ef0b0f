#include "core/formats/outline.h"

#include <bit>

#include "core/formats/polygon_normal.h"
#include "core/numerics/orientation.h"

namespace etalon {
namespace {

/// Number of pairs of boxes that are tested for a corner, so that no outline takes quadratic time.
constexpr std::size_t pairs_a_corner = 1000;

/// Finds edges that cross by a complete binary tree of bounding boxes over the edges in order.
class EdgeTree {
  public:
    explicit EdgeTree(const std::vector<Vec2>& outline)
        : outline_(outline), leaves_(std::bit_ceil(outline.size())), boxes_(2 * leaves_) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            boxes_[leaves_ + i].extendBy(outline[i]);
            boxes_[leaves_ + i].extendBy(end_of(i));
        }
        for (std::size_t i = leaves_ - 1; i > 0; --i) {
            boxes_[i] = boxes_[2 * i];
            boxes_[i].extendBy(boxes_[2 * i + 1]);
        }
    }

    /// Returns whether two of the edges below a node cross.
    bool has_crossing(std::size_t node = 1) {
        if (node >= leaves_) return false;
        return has_crossing(2 * node) || has_crossing(2 * node + 1) ||
               any_cross(2 * node, 2 * node + 1);
    }

  private:
    const Vec2& end_of(std::size_t edge) const { return outline_[(edge + 1) % outline_.size()]; }

    /// Returns whether an edge below one node crosses one below another of the same level.
    bool any_cross(std::size_t p, std::size_t q) {
        if (pairs_left_ == 0 || !boxes_[p].intersects(boxes_[q])) return false;
        --pairs_left_;
        if (p >= leaves_) return cross(p - leaves_, q - leaves_);
        return any_cross(2 * p, 2 * q) || any_cross(2 * p, 2 * q + 1) ||
               any_cross(2 * p + 1, 2 * q) || any_cross(2 * p + 1, 2 * q + 1);
    }

    bool cross(std::size_t p, std::size_t q) const { return separates(p, q) && separates(q, p); }

    /// Returns whether the ends of edge q lie on different sides of edge p.
    bool separates(std::size_t p, std::size_t q) const {
        const double first = orientation(outline_[p], end_of(p), outline_[q]);
        const double second = orientation(outline_[p], end_of(p), end_of(q));
        return (first > 0 && second < 0) || (first < 0 && second > 0);
    }

    const std::vector<Vec2>& outline_;
    std::size_t leaves_;               ///< the children of node i are 2i and 2i + 1
    std::vector<Imath::Box2d> boxes_;  ///< of the edges below a node
    std::size_t pairs_left_ = pairs_a_corner * outline_.size();
};

}  // namespace

std::vector<Vec2> projected_outline(std::span<const Vec3> corners) {
    const Vec3 normal = area_normal(corners);
    const int axis = dominant_axis(normal);
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x, y);
    std::vector<Vec2> outline;
    outline.reserve(corners.size());
    for (const Vec3& p : corners) outline.emplace_back(p[x], p[y]);
    return outline;
}

bool crosses_itself(const std::vector<Vec2>& outline) {
    return EdgeTree(outline).has_crossing();
}

}  // namespace etalon
