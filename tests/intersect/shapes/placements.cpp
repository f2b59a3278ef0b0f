#include "tests/intersect/shapes/placements.h"

#include <cmath>

#include "core/numerics/local_frame.h"

namespace etalon {

Vec3 tilted(double x, double y, double z) {
    const Vec3 w = normalized({17, 11, 7});
    Vec3 u, v;
    orthonormal_basis(w, u, v);
    return x * u + y * v + z * w;
}

Affine rotation() {
    return {tilted(1, 0, 0), tilted(0, 1, 0), tilted(0, 0, 1), base};
}

Affine scaling(double x, double y, double z) {
    return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}

Box3 around(const Vec3& centre, double reach) {
    return {centre - Vec3(reach), centre + Vec3(reach)};
}

double nearly_one(Random& random) {
    return 1 + random.sign() * std::pow(10.0, random.uniform(-18, -1));
}

}  // namespace etalon
