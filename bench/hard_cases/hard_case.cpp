#include "bench/hard_cases/hard_case.h"

#include "bench/hard_cases/aims.h"
#include "bench/hard_cases/families.h"

namespace etalon::hard {
namespace {

using MakeCases = std::vector<HardCase> (*)();

/// One line for each family; the table of another shape goes here.
constexpr MakeCases families[] = {
    sphere_cases,        shell_cases, cylinder_cases, cone_cases,           plane_cases,
    plane_pair_cases,    box_cases,   triangle_cases, triangle_group_cases, polygon_cases,
    polygon_group_cases, aimed_cases, mesh_cases,
};

double in_float(double x) {
    return static_cast<float>(x);
}

}  // namespace

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> all;
    for (const MakeCases make : families) {
        for (HardCase& c : make()) all.push_back(std::move(c));
    }
    return all;
}

Ray in_float(Ray ray) {
    return {rounded(ray.origin), rounded(ray.direction), in_float(ray.tmin), in_float(ray.tmax)};
}

}  // namespace etalon::hard
