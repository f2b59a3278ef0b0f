#include "bench/scenes/flattened.h"

#include <map>

namespace etalon::bench {
namespace {

/// The distinct vertices of an object's triangles.
struct UsedVertices {
    explicit UsedVertices(const Geometry& object) {
        for (const TriangleIndices t : object.all<Triangle>()) {
            for (const std::uint32_t v : t) {
                if (place.try_emplace(v, points.size()).second) points.push_back(object.vertex(v));
            }
        }
    }

    std::vector<Vec3> points;
    std::map<std::uint32_t, std::size_t> place;  ///< index of a vertex among the points
};

void add_copy(const Geometry& object, const UsedVertices& used, const Affine& map, Geometry& to) {
    const auto first = static_cast<std::uint32_t>(to.vertices.size());
    for (const Vec3& p : used.points) to.add_vertex(map.point(p));
    for (const Primitive p : object.primitives) {
        if (p.kind != kind_of<Triangle>()) continue;
        Triangle copy{object.get<Triangle>(p).vertices};
        for (std::uint32_t& v : copy.vertices) {
            v = first + static_cast<std::uint32_t>(used.place.at(v));
        }
        to.add(copy, p.material, p.sides);
    }
}

}  // namespace

Geometry flattened(const Geometry& geometry) {
    Geometry flat = geometry;
    flat.objects.clear();
    flat.instances.clear();
    const std::vector<UsedVertices> used(geometry.objects.begin(), geometry.objects.end());
    for (const Instance& instance : geometry.instances) {
        add_copy(geometry.objects[instance.object], used[instance.object], instance.to_world(),
                 flat);
    }
    return flat;
}

}  // namespace etalon::bench
