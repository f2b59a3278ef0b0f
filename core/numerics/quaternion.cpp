#include "core/numerics/quaternion.h"

#include <array>
#include <cmath>

namespace etalon {

/// Computes the largest of the four numbers from the diagonal, the others from sums and differences
/// across it (Shoemake 1985, "Animating Rotation with Quaternion Curves").
Quaternion quaternion_of(const Affine& m) {
    const Affine columns = m;
    const std::array<Vec3, 3> c = {columns.x, columns.y, columns.z};
    const double trace = c[0][0] + c[1][1] + c[2][2];
    Quaternion q;
    if (trace > 0) {
        q.w = (trace + 1) / 2;
        q.v = Vec3(c[1][2] - c[2][1], c[2][0] - c[0][2], c[0][1] - c[1][0]) / 2;
        return normalized(q);
    }
    int i = c[1][1] > c[0][0] ? 1 : 0;
    if (c[2][2] > c[static_cast<std::size_t>(i)][i]) i = 2;
    const auto a = static_cast<std::size_t>(i), b = (a + 1) % 3, d = (a + 2) % 3;
    const auto at = [](std::size_t k) { return static_cast<int>(k); };
    q.v[i] = (c[a][i] - c[b][at(b)] - c[d][at(d)] + 1) / 2;
    q.v[at(b)] = (c[a][at(b)] + c[b][i]) / 2;
    q.v[at(d)] = (c[a][at(d)] + c[d][i]) / 2;
    q.w = (c[b][at(d)] - c[d][at(b)]) / 2;
    return normalized(q);
}

Affine rotation_of(const Quaternion& q) {
    const double x = q.v.x, y = q.v.y, z = q.v.z, w = q.w;
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
            {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
            {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

Quaternion normalized(const Quaternion& q) {
    return (1 / std::sqrt(q.dot(q))) * q;
}

}  // namespace etalon
