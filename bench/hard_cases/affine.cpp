#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_generators.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

Affine scaling(double x, double y, double z) {
    return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

/// Returns a map with every number rounded to float.
Affine of_floats(const Affine& map) {
    return {rounded(map.x), rounded(map.y), rounded(map.z), rounded(map.origin)};
}

Affine at(const Vec3& place, Affine map) {
    map.origin = place;
    return of_floats(map);
}

/// Returns a map that tilts all coordinate axes.
Affine askew() {
    return {tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1), {0, 0, 0}};
}

Affine turned() {
    return {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}, {0, 0, 0}};
}

Affine sheared() {
    return {{1, 0, 0}, {0.5, 1, 0}, {-2, 3, 1}, {0, 0, 0}};
}

/// Returns a map of that condition number, under which the ellipsoid's axes are parallel to no axis
/// of local or world space.
Affine of_condition(double condition) {
    const double root = std::sqrt(condition);
    return askew() * scaling(1, 1 / root, 1 / condition) * turned() * askew();
}

/// Returns a product of maps, as nested instances have, each rounded to float.
Affine nested(int depth) {
    const Affine step{{0.9, 0.1, 0}, {-0.2, 0.8, 0.3}, {0.1, 0.4, -1.1}, {0.5, -0.25, 0.125}};
    Affine map;
    for (int i = 0; i < depth; ++i) map = of_floats(map * step);
    return map;
}

struct NamedMap {
    std::string name;
    Affine map;
};

/// Returns the maps by which CYL-5 stretches, shears and mirrors its cylinder.
std::vector<NamedMap> odd_maps() {
    const Vec3 here = usual_place();
    return {
        {"unit", Affine()},
        {"needle, 1e4 long", at(here, scaling(1, 1, 1e4))},
        {"needle, 1e4 long, askew", at(here, askew() * scaling(1, 1, 1e4))},
        {"disk, 1e-4 high, askew", at(here, askew() * scaling(1, 1, 1e-4))},
        {"sheared", at(here, sheared())},
        {"mirrored", at(here, askew() * scaling(1, -1, 2))},
        {"mirrored and sheared", at(here, sheared() * scaling(1, 1, -0.5))},
        {"condition 1e6", at(here, of_condition(1e6))},
    };
}

/// Returns maps with which an instance may be placed.
std::vector<NamedMap> instance_maps() {
    const Vec3 here = usual_place();
    std::vector<NamedMap> maps;
    for (int k = 0; k <= 8; k += 2) {
        maps.push_back({"condition " + power_of_ten(k), at(here, of_condition(std::pow(10.0, k)))});
    }
    maps.push_back({"mirrored", at(here, askew() * scaling(-1, 2, 0.5))});
    maps.push_back({"nested 8 deep", nested(8)});
    maps.push_back({"translated by 1e6", at({1e6, 3e5, -9e5}, askew() * scaling(1, 2, 0.5))});
    return maps;
}

template <class Shape>
CaseSetup aimed_at(const Affine& map, const MakeRay& ray) {
    return only(Shape(map), map.x.length() + map.y.length() + map.z.length(), ray);
}

/// Rays from all around at the shape's targets.
template <class Shape>
CaseSetup aimed(const Affine& map) {
    CaseSetup setup = aimed_at<Shape>(map, nullptr);
    const std::vector<Target> targets = targets_of(setup.scene.geometry, 0, to_the_last_bit);
    const Extent extent{map.point({0, 0, 0.5}), setup.size};
    setup.ray = [=](Random& random) {
        return ray_generator(extent, targets[random.index(targets.size())], random);
    };
    return setup;
}

/// Rays from inside and outside at all parts of the surface, generated in local coordinates.
template <class Shape>
CaseSetup arriving(const Affine& map) {
    CaseSetup setup = aimed_at<Shape>(map, nullptr);
    const std::vector<Target> targets = targets_of(setup.scene.geometry, 0, to_the_last_bit);
    setup.ray = [=](Random& random) {
        const bool inside = random.index(2) == 0;
        const Vec3 local =
            (inside ? random.uniform(0, 0.45) : random.uniform(2, 4)) * random.direction() +
            Vec3(0, 0, 0.5);
        const Vec3 origin = map.point(local);
        return towards(origin, targets[random.index(targets.size())](origin, random));
    };
    return setup;
}

template <class Shape>
void add_shape(Rows& rows, const std::string& id, const NamedMap& named) {
    const Affine map = named.map;
    rows.add_both(id, named.name, [map] { return aimed<Shape>(map); });
    rows.add(
        id, named.name + ", leaving", [map] { return arriving<Shape>(map); }, Criterion::spawned);
}

template <class Shape>
void add_instances(Rows& rows) {
    for (const NamedMap& named : instance_maps()) {
        add_shape<Shape>(rows, "INS-1", {std::string(Shape::name) + ", " + named.name, named.map});
    }
}

}  // namespace

std::vector<HardCase> ellipsoid_cases() {
    Rows rows("ellipsoid");
    add_instances<Ellipsoid>(rows);
    return rows.take();
}

std::vector<HardCase> closed_cylinder_cases() {
    Rows rows("cylinder");
    for (const NamedMap& named : odd_maps()) add_shape<ClosedCylinder>(rows, "CYL-5", named);
    add_instances<ClosedCylinder>(rows);
    return rows.take();
}

}  // namespace etalon::hard
