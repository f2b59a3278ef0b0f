#include "core/intersect/object_outline.h"

#include <algorithm>
#include <vector>

#include "core/intersect/kernels.h"
#include "core/intersect/near_region.h"

namespace etalon {
namespace {

/// Limits between which sums, differences and roundings of coordinates stay in the range of double.
constexpr double largest_coordinate = 0x1p1000, smallest_size = 0x1p-900;

bool is_in_range(const Box3& box) {
    const double size = max_abs(box.size());
    return std::max(max_abs(box.min), max_abs(box.max)) < largest_coordinate &&
           (size >= smallest_size || size == 0);
}

Box3 box_of(const Geometry& object) {
    Box3 all;
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        all.extendBy(whole_bounds(object, id));
    }
    return all;
}

/// Marks vertices of triangles.
class VisitedVertices {
  public:
    explicit VisitedVertices(const Geometry& object)
        : decimals_begin_(object.vertices.size()),
          visited_(decimals_begin_ + object.decimal_vertices.size()) {}

    /// Returns whether it is the first time that a vertex is visited.
    bool visit(std::uint32_t number) {
        const bool is_decimal = (number & decimal_vertex) != 0;
        const auto at = visited_.begin() +
                        static_cast<std::ptrdiff_t>(
                            is_decimal ? decimals_begin_ + (number & ~decimal_vertex) : number);
        const bool is_first = !*at;
        *at = true;
        return is_first;
    }

  private:
    std::size_t decimals_begin_;
    std::vector<bool> visited_;
};

/// Calls visit(centre, radius) for balls whose convex hull contains the object: spheres, the
/// vertices of triangles, and the corners of the boxes of all else.
template <class Visit>
void visit_balls(const Geometry& object, const Visit& visit) {
    VisitedVertices visited(object);
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        const Primitive p = object.primitives[id];
        const Box3 box = whole_bounds(object, id);
        if (box.isEmpty()) continue;
        if (p.kind == kind_of<Triangle>()) {
            for (const std::uint32_t number : object.get<Triangle>(p).vertices) {
                if (visited.visit(number)) visit(object.vertex(number), 0);
            }
        } else if (p.kind == kind_of<Sphere>()) {
            const Sphere& sphere = object.get<Sphere>(p);
            visit(sphere.centre, sphere.radius);
        } else {
            for_each_corner(box, [&](const Vec3& corner) { visit(corner, 0); });
        }
    }
}

}  // namespace

ObjectOutline::ObjectOutline(const Geometry& object) : box_(box_of(object)) {
    if (box_.isEmpty()) return;
    if (!is_in_range(box_)) {
        box_ = everywhere();
        return;
    }
    visit_balls(object, [&](const Vec3& centre, double radius) {
        extents_.extend_by(centre - box_.center(), radius);
    });
}

Box3 ObjectOutline::image(const Affine& map) const {
    if (!is_bounded(box_)) return box_;
    const Vec3 centre = map.point(box_.center());
    Box3 image;
    for (int k = 0; k < 3; ++k) {
        const auto [along, against] = extents_.extent({map.x[k], map.y[k], map.z[k]});
        image.min[k] = centre[k] - against;
        image.max[k] = centre[k] + along;
    }
    return is_bounded(image) ? image : everywhere();
}

}  // namespace etalon
