#include "core/formats/corner_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "core/numerics/orientation.h"

namespace etalon {
namespace {

/// Returns whether no point of the box lies to the left of the edge or on it.
bool is_right_of(const Box2& box, const Vec2& a, const Vec2& b) {
    const Vec2 leftmost(b.y > a.y ? box.min.x : box.max.x, b.x > a.x ? box.max.y : box.min.y);
    return orientation(a, b, leftmost) < 0;
}

}  // namespace

/// By the separating axes of a box and a triangle.
bool PlaneTriangle::meets(const Box2& box) const {
    Box2 own(a);
    own.extendBy(b);
    own.extendBy(c);
    return own.intersects(box) && !is_right_of(box, a, b) && !is_right_of(box, b, c) &&
           !is_right_of(box, c, a);
}

CornerTree::CornerTree(const std::vector<Vec2>& outline)
    : outline_(outline),
      leaves_(std::bit_ceil(outline.size())),
      node_(outline.size()),
      boxes_(2 * leaves_) {
    std::vector<std::uint32_t> order(outline.size());
    std::iota(order.begin(), order.end(), 0U);
    sort(order.data(), order.data() + order.size(), leaves_, 0);
    for (std::size_t i = 0; i < order.size(); ++i) node_[order[i]] = leaves_ + i;
}

/// Sorts corners into the leaves of a subtree that has room for them.
void CornerTree::sort(std::uint32_t* first, std::uint32_t* last, std::size_t room, int axis) {
    const std::size_t half = room / 2;
    if (half == 0) return;
    if (static_cast<std::size_t>(last - first) > half) {
        std::nth_element(first, first + half, last, [&](std::uint32_t a, std::uint32_t b) {
            return outline_[a][axis] < outline_[b][axis];
        });
        sort(first + half, last, half, 1 - axis);
        last = first + half;
    }
    sort(first, last, half, 1 - axis);
}

void CornerTree::set(std::uint32_t corner, bool member) {
    std::size_t node = node_[corner];
    boxes_[node] = member ? Box2(outline_[corner]) : Box2();
    while (node /= 2) {
        boxes_[node] = boxes_[2 * node];
        boxes_[node].extendBy(boxes_[2 * node + 1]);
    }
}

bool CornerTree::any_in(const PlaneTriangle& triangle, std::size_t node) const {
    const Box2& box = boxes_[node];
    if (box.isEmpty() || !triangle.meets(box)) return false;
    if (node >= leaves_) return !triangle.has_corner(box.min);
    return any_in(triangle, 2 * node) || any_in(triangle, 2 * node + 1);
}

}  // namespace etalon
