#include "bench/hard_cases/hard_case.h"

#include <algorithm>
#include <iterator>

#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

double in_float(double x) {
    return static_cast<float>(x);
}

}  // namespace

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> all;
    const auto add = [&all](std::vector<HardCase> cases) {
        std::move(cases.begin(), cases.end(), std::back_inserter(all));
    };
    // The table of another shape is one more line here and in case_families.h.
    add(sphere_cases());
    add(shell_cases());
    add(cylinder_cases());
    add(cone_cases());
    add(ellipsoid_cases());
    add(closed_cylinder_cases());
    add(plane_cases());
    add(plane_pair_cases());
    add(box_cases());
    add(triangle_cases());
    add(triangle_group_cases());
    add(polygon_cases());
    add(polygon_group_cases());
    add(ring_cases());
    add(curve_cases());
    add(ring_pair_cases());
    add(quadric_cases());
    add(quadric_group_cases());
    add(revolved_cases());
    add(aimed_cases());
    add(mesh_cases());
    add(random_scene_cases());
    add(tree_cases());
    add(instance_cases());
    add(adversarial_cases());
    add(grid_cases());
    add(range_cases());
    return all;
}

Ray in_float(Ray ray) {
    return {rounded(ray.origin), rounded(ray.direction), in_float(ray.tmin), in_float(ray.tmax)};
}

}  // namespace etalon::hard
