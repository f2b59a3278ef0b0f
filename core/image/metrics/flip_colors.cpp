#include "core/image/metrics/flip_colors.h"

namespace etalon {
namespace {

/// CIE XYZ of linear RGB for the chromaticities of IEC 61966-2-1, as exact quotients. To be used
/// with row vectors, as Imath does.
const Imath::M33d xyz_of_rgb = [] {
    constexpr double d = 73733382;
    return Imath::M33d(30406656 / d, 15678432 / d, 1425312 / d,  //
                       26366430 / d, 52732860 / d, 8788810 / d,  //
                       13305225 / d, 5322090 / d, 70074185 / d);
}();
const Imath::M33d rgb_of_xyz = xyz_of_rgb.inverse();
const Vec3 white = Vec3(1) * xyz_of_rgb;

/// Curve of CIE 1976: a cube root with a straight piece near black.
double lab_curve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

/// L*, a*, b* of the three curved or uncurved quotients X / Xn, Y / Yn, Z / Zn.
Vec3 opponents(const Vec3& q) {
    return {116 * q.y - 16, 500 * (q.x - q.y), 200 * (q.y - q.z)};
}

}  // namespace

Vec3 ycxcz_of_linear(const Vec3& rgb) {
    return opponents(rgb * xyz_of_rgb / white);
}

Vec3 linear_of_ycxcz(const Vec3& c) {
    const double y = (c.x + 16) / 116;
    return Vec3(y + c.y / 500, y, y - c.z / 200) * white * rgb_of_xyz;
}

Vec3 hunt_lab_of_linear(const Vec3& rgb) {
    const Vec3 q = rgb * xyz_of_rgb / white;
    const Vec3 lab = opponents({lab_curve(q.x), lab_curve(q.y), lab_curve(q.z)});
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double hyab(const Vec3& a, const Vec3& b) {
    const double red_green = a.y - b.y, blue_yellow = a.z - b.z;
    return std::abs(a.x - b.x) + std::sqrt(red_green * red_green + blue_yellow * blue_yellow);
}

}  // namespace etalon
