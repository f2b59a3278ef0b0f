#include "core/intersect/tree/triangle_pieces.h"

#include <bit>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Planes an axis of the frame has, as a power of two.
constexpr int levels = 30;

/// Where an edge from one side of a plane to the other passes it. The weight is good to 3.1 u, its
/// product with the edge, of at most twice the largest coordinate, to 5.2 u of that, and the sum
/// rounds once more: 12 u of the largest coordinate in all.
Box3 crossing(const Vec3& a, const Vec3& b, const MedianPlane& plane) {
    const double weight = (plane.position - a[plane.axis]) / (b[plane.axis] - a[plane.axis]);
    Vec3 low, high;
    for (int k = 0; k < 3; ++k) {
        const double x = a[k] + weight * (b[k] - a[k]);
        const double error = 12 * unit_roundoff * std::max(std::abs(a[k]), std::abs(b[k]));
        low[k] = x - error;
        high[k] = x + error;
    }
    return {low, high};
}

Box3 intersection(const Box3& a, const Box3& b) {
    Box3 both;
    for (int k = 0; k < 3; ++k) {
        both.min[k] = std::max(a.min[k], b.min[k]);
        both.max[k] = std::min(a.max[k], b.max[k]);
    }
    return both;
}

double longest_side(const Box3& box) {
    return max_abs(box.size());
}

}  // namespace

std::optional<MedianPlane> first_median(const Box3& world, const Frame& frame) {
    const Vec3 low = frame.point(world.min), high = frame.point(world.max);
    std::optional<MedianPlane> first;
    for (int k = 0; k < 3; ++k) {
        // Planes of the cube [-1, 1]^3 are whole numbers from 0 to 2^levels here: those from
        // `below` + 1 to `above` lie strictly between the box's sides.
        constexpr double planes = 1 << (levels - 1);
        const auto below = static_cast<std::int32_t>(std::floor((low[k] + 1) * planes));
        const auto above = static_cast<std::int32_t>(std::ceil((high[k] + 1) * planes)) - 1;
        if (below >= above) continue;
        const int bit = std::bit_width(static_cast<std::uint32_t>(below ^ above)) - 1;
        const int level = levels - 1 - bit;
        if (first && (first->level < level ||
                      (first->level == level && world.size()[first->axis] >= world.size()[k]))) {
            continue;
        }
        const double local = static_cast<double>((above >> bit) << bit) / planes - 1;
        const double position = (local - frame.point(Vec3(0))[k]) / frame.scale();
        if (position > world.min[k] && position < world.max[k]) first = {k, position, level};
    }
    return first;
}

std::array<Box3, 2> cut(const Corners& corners, const Box3& box, const MedianPlane& plane) {
    std::array<Box3, 2> sides;
    for (int i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        const double from = a[plane.axis], to = b[plane.axis];
        if (from <= plane.position) sides[0].extendBy(a);
        if (from >= plane.position) sides[1].extendBy(a);
        if (std::min(from, to) < plane.position && plane.position < std::max(from, to)) {
            const Box3 at = crossing(a, b, plane);
            sides[0].extendBy(at);
            sides[1].extendBy(at);
        }
    }
    std::array<Box3, 2> halves{box, box};
    halves[0].max[plane.axis] = halves[1].min[plane.axis] = plane.position;
    return {intersection(sides[0], halves[0]), intersection(sides[1], halves[1])};
}

/// What is left of the cuts goes to the halves by their longest sides, as in Karras & Aila 2013.
void add_pieces(const Corners& corners, const Box3& box, int cuts, const Frame& frame,
                std::vector<Box3>& pieces) {
    if (box.isEmpty()) return;
    const auto plane = cuts > 0 ? first_median(box, frame) : std::nullopt;
    if (!plane) {
        pieces.push_back(box);
        return;
    }
    const auto [below, above] = cut(corners, box, *plane);
    const double a = below.isEmpty() ? 0 : longest_side(below);
    const double b = above.isEmpty() ? 0 : longest_side(above);
    const int left = cuts - 1;
    const int to_below = a + b > 0 ? static_cast<int>(left * a / (a + b) + 0.5) : 0;
    add_pieces(corners, below, to_below, frame, pieces);
    add_pieces(corners, above, left - to_below, frame, pieces);
}

}  // namespace etalon
