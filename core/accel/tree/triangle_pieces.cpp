#include "core/accel/tree/triangle_pieces.h"

#include <algorithm>
#include <bit>

namespace etalon {
namespace {

using Corner = Bounds::Corner;

/// Number of planes along an axis of normalized space, as a power of two. With more, their distance
/// would be smaller than the padding of boxes.
constexpr int levels = 20;

/// Returns the point where an edge from one side of a plane to the other crosses it. The weight is
/// good to 3.1 u, its product with the edge, of at most twice the largest coordinate, to 5.2 u of
/// that, and the sum rounds once more: 12 u of the largest coordinate in all.
Corner crossing(Corner a, Corner b, const MedianPlane& plane) {
    const float weight = (plane.position - a[plane.axis]) / (b[plane.axis] - a[plane.axis]);
    return a + weight * (b - a);
}

Bounds intersection(const Bounds& a, const Bounds& b) {
    Bounds both;
    both.min = Bounds::upper(a.min, b.min);
    both.max = Bounds::lower(a.max, b.max);
    return both;
}

bool is_empty(const Bounds& box) {
    const Corner size = box.max - box.min;
    return std::min({size[0], size[1], size[2]}) < -2 * piece_error;
}

float longest_side(const Bounds& box) {
    const Corner size = box.max - box.min;
    return std::max({size[0], size[1], size[2], 0.0F});
}

/// Returns the number of the corner that a plane separates from the two others.
std::size_t separated_corner(const Corners& corners, const MedianPlane& plane) {
    std::array<bool, 3> below;
    for (std::size_t i = 0; i < 3; ++i) below[i] = corners[i][plane.axis] < plane.position;
    return below[0] == below[1] ? 2 : (below[0] == below[2] ? 1 : 0);
}

}  // namespace

Corners corners_in(const NormalizedSpace& space, const std::array<Vec3, 3>& world) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f p(space.point(world[i]));
        corners[i] = Corner{p.x, p.y, p.z, 0};
    }
    return corners;
}

Bounds bounds_of(const Corners& corners) {
    Bounds bounds;
    for (const Corner& corner : corners) bounds.extend(corner);
    return bounds;
}

std::optional<MedianPlane> first_median(const Bounds& box) {
    using Numbers = std::int32_t __attribute__((vector_size(16)));
    // Here the planes of the cube [-1, 1]^3 are integers from 0 to 2^levels: those from `below` + 1
    // to `above` lie strictly between the box's sides, up to roundings.
    constexpr float planes = 1 << (levels - 1);
    const Corner low = (box.min + 1) * planes, high = (box.max + 1) * planes;
    const auto below = __builtin_convertvector(low, Numbers);
    auto above = __builtin_convertvector(high, Numbers);
    above += __builtin_convertvector(above, Corner) == high;  // -1 where that holds
    const Corner size = box.max - box.min;
    std::optional<MedianPlane> first;
    int highest = -1;
    for (int k = 0; k < 3; ++k) {
        if (below[k] >= above[k]) continue;
        const int bit = std::bit_width(static_cast<std::uint32_t>(below[k] ^ above[k])) - 1;
        if (bit < highest || (bit == highest && size[first->axis] >= size[k])) continue;
        const float position = static_cast<float>((above[k] >> bit) << bit) / planes - 1;
        if (!(position > box.min[k] && position < box.max[k])) continue;
        first = {k, position};
        highest = bit;
    }
    return first;
}

std::array<Bounds, 2> cut(const Corners& corners, const Bounds& box, const MedianPlane& plane) {
    const std::size_t i = separated_corner(corners, plane);
    const Corner &a = corners[i], &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    Bounds at_plane;
    at_plane.extend(crossing(a, b, plane));
    at_plane.extend(crossing(a, c, plane));
    Bounds one = at_plane, two = at_plane;
    one.extend(a);
    two.extend(b);
    two.extend(c);
    const bool is_below = a[plane.axis] < plane.position;
    Bounds lower = box, upper = box;
    lower.max[plane.axis] = upper.min[plane.axis] = plane.position;
    return {intersection(is_below ? one : two, lower), intersection(is_below ? two : one, upper)};
}

/// Shares the remaining cuts between the halves by longest side, as in Karras & Aila 2013.
void add_pieces(const Corners& corners, const Bounds& box, int cuts, std::vector<Bounds>& pieces) {
    if (is_empty(box)) return;
    const auto plane = cuts > 0 ? first_median(box) : std::nullopt;
    if (!plane) {
        pieces.push_back(box);
        return;
    }
    const auto [below, above] = cut(corners, box, *plane);
    const float a = longest_side(below), b = longest_side(above);
    const int left = cuts - 1;
    const int to_below =
        a + b > 0 ? static_cast<int>(static_cast<float>(left) * a / (a + b) + 0.5F) : 0;
    add_pieces(corners, below, to_below, pieces);
    add_pieces(corners, above, left - to_below, pieces);
}

}  // namespace etalon
