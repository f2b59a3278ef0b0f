#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {

Vec3 rounded(const Vec3& v) {
    return Vec3(Vec3f(v));
}

Vec3 tilted(double x, double y, double z) {
    const Vec3 w = normalized({17, 11, 7});
    Vec3 u, v;
    orthonormal_basis(w, u, v);
    return x * u + y * v + z * w;
}

Vec3 in_disc(const Vec3& axis, Random& random) {
    const double radius = std::sqrt(random.uniform());
    return radius * across(axis, random.uniform(0, turn));
}

Vec3 axis_direction(Random& random) {
    Vec3 d;
    for (int k = 0; k < 3; ++k) d[k] = random.sign() * 0.0;
    const int axis = random.axis();
    d[axis] = random.sign();
    return d;
}

}  // namespace etalon::hard
