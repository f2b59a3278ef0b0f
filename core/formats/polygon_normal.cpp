#include "core/formats/polygon_normal.h"

#include "core/numerics/rounding.h"

namespace etalon {

bool is_of_unit_length(const Vec3& v) {
    return std::abs(v.dot(v) - 1) <= 8 * unit_roundoff;
}

Vec3 area_normal(std::span<const Vec3> corners) {
    double extent = 0;
    for (const Vec3& p : corners) extent = std::max(extent, max_abs(p - corners[0]));
    const double scale = power_of_two_reciprocal(extent);
    Vec3 sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        sum += ((corners[i - 1] - corners[0]) * scale).cross((corners[i] - corners[0]) * scale);
    }
    return sum;
}

}  // namespace etalon
