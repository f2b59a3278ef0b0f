#include "native_accel/grid/grid.h"

#include "native_accel/common/isa.h"

namespace etalon {
namespace {

bool is_sphere(const BoundedPrimitive& p) {
    return static_cast<ShapeKind>(p.kind) == kind_of<Sphere>();
}

std::vector<SphereItem> sphere_items(const Geometry& geometry, const NormalizedSpace& space,
                                     const std::vector<BoundedPrimitive>& primitives) {
    std::vector<SphereItem> items;
    for (const BoundedPrimitive& p : primitives) {
        if (!is_sphere(p)) continue;
        const Sphere& s = geometry.get<Sphere>(geometry.primitives[p.id]);
        items.push_back({p.box(), p.id, space.point(s.centre), s.radius * space.scale()});
    }
    return items;
}

}  // namespace

Grid::Grid(const Geometry& geometry) : Intersector(geometry) {
    build_objects<Grid>();
    const NormalizedSpace& space = scene_bounds().space;
    std::vector<BoundedPrimitive> primitives = take_bounded();
    spheres_ = PackedGrid<SpherePack>(sphere_items(geometry, space, primitives));
    std::erase_if(primitives, is_sphere);
    if (!primitives.empty()) others_ = ClusterGrid(geometry, space, std::move(primitives));
}

std::size_t Grid::own_bytes() const {
    return spheres_.memory_bytes() + others_.memory_bytes();
}

std::string Grid::isa() const {
    return traversal_isa();
}

void Grid::closest_bounded(const RayQuery& query, const NormalizedRay& local,
                           NearestHit& nearest) const {
    trace_.closest(view(), query, local, nearest);
}

void Grid::closest_counted(const RayQuery& query, const NormalizedRay& local, NearestHit& nearest,
                           TraversalCost& cost) const {
    trace_closest_counted(view(), query, local, nearest, cost);
}

bool Grid::occluded_bounded(const RayQuery& query, const NormalizedRay& local) const {
    return trace_.occluded(view(), query, local);
}

}  // namespace etalon
