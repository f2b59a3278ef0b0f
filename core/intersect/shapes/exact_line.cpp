#include "core/intersect/shapes/exact_line.h"

namespace etalon {

ExactLine::ExactLine(const Affine& map, const Ray& ray) {
    const DyadicVec x = exactly(map.x), y = exactly(map.y), z = exactly(map.z);
    const DyadicVec adjugate[] = {cross(y, z), cross(z, x), cross(x, y)};
    const DyadicVec from = difference(ray.origin, map.origin), towards = exactly(ray.direction);
    unit = dot(x, adjugate[0]);
    const bool mirrors = unit.sign() < 0;
    if (mirrors) unit = -unit;
    for (std::size_t k = 0; k < 3; ++k) {
        w[k] = dot(adjugate[k], from);
        d[k] = dot(adjugate[k], towards);
        if (mirrors) w[k] = -w[k], d[k] = -d[k];
    }
}

}  // namespace etalon
