#include "bench/scenes/sphereflake_spheres.h"

#include "core/test_rays/directions.h"

namespace etalon::bench {
namespace {

void grow(std::vector<Sphere>& spheres, const Sphere& s, const Vec3& pole, std::size_t depth) {
    spheres.push_back(s);
    if (depth == 0) return;
    const auto bear = [&](const Vec3& outward) {
        const Sphere child{s.centre + s.radius * 4 / 3 * outward, s.radius / 3};
        grow(spheres, child, outward, depth - 1);
    };
    for (int k = 0; k < 6; ++k) bear(across(pole, turn * k / 6));
    const double height = std::sqrt(2.0 / 3.0), radius = std::sqrt(1.0 / 3.0);
    for (int k = 0; k < 3; ++k) {  // above the gaps between every other pair of the six
        bear(height * pole + radius * across(pole, turn * (k / 3.0 + 1 / 12.0)));
    }
}

}  // namespace

std::vector<Sphere> sphereflake_spheres(std::size_t depth) {
    std::vector<Sphere> spheres;
    grow(spheres, {Vec3(0), 1}, Vec3(0, 1, 0), depth);
    return spheres;
}

}  // namespace etalon::bench
