#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/ray_targets.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {
namespace {

const Plane level{{0, 0, 0}, {0, 0, 1}};

Plane oblique() {
    return {usual_place(), rounded({1.7, 1.1, 0.7})};
}

/// Rays from a distance of 1e6, towards the plane or away from it, at exactly this cosine.
CaseSetup nearly_along(double cosine) {
    return only(level, 1, [=](Random& random) {
        const Vec3 place = 1e6 * random.direction();
        const double angle = random.uniform(0, turn), sign = random.sign();
        return Ray{place, {std::cos(angle), std::sin(angle), sign * cosine}};
    });
}

/// The same for a plane with a random normal: the cosine is exact up to rounding.
CaseSetup nearly_along_oblique(double cosine) {
    const Plane plane = oblique();
    const Vec3 n = plane.normal.normalized();
    return only(plane, 1, [=](Random& random) {
        const Vec3 place = 1e6 * random.direction();
        const double sign = random.sign();
        return Ray{place, across(n, random.uniform(0, turn)) + sign * cosine * n};
    });
}

/// Rays in the plane itself.
CaseSetup within() {
    return only(level, 1, [](Random& random) {
        const double angle = random.uniform(0, turn), zero = random.sign() * 0.0;
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        return Ray{{x, y, random.sign() * 0.0}, {std::cos(angle), std::sin(angle), zero}};
    });
}

/// Returns a ray to a point of the plane from a distance between 1e-3 and 1e6.
Ray at_plane(const Plane& plane, Random& random) {
    const Vec3 d = random.direction(), along = plane.normal.normalized().cross(random.in_cube());
    const double distance = random.magnitude(-3, 6);
    return {plane.point + along - distance * d, d};
}

/// Two planes, hit from both sides; `second` may equal the first. Distances to planes are more
/// accurate than kernels must be, so that nearly coincident planes keep their order.
CaseSetup pair(const Plane& first, const Plane& second) {
    constexpr double tie = 0x1p-48;
    CaseSetup setup{{}, 1, [=](Random& random) { return at_plane(first, random); }, tie};
    setup.scene.geometry.add(first, 0);
    setup.scene.geometry.add(second, 0);
    return setup;
}

Plane raised(Plane plane, double height) {
    plane.point.z += height;
    return plane;
}

}  // namespace

std::vector<HardCase> plane_cases() {
    Rows rows("plane");
    rows.add_both("PLN-1", "cosine 1e-3", [] { return nearly_along(1e-3); });
    rows.add_both("PLN-1", "cosine 1e-7", [] { return nearly_along(1e-7); });
    rows.add_both("PLN-1", "cosine 1e-38", [] { return nearly_along(1e-38); });
    rows.add("PLN-1", "cosine 1e-140", [] { return nearly_along(1e-140); });
    rows.add("PLN-1", "cosine 1e-290", [] { return nearly_along(1e-290); });
    rows.add_both("PLN-1", "cosine 0", [] { return nearly_along(0); });
    rows.add_both("PLN-1", "within the plane", within);
    for (const int k : {3, 7}) {
        rows.add_both("PLN-1", "oblique, cosine " + power_of_ten(-k),
                      [k] { return nearly_along_oblique(std::pow(10.0, -k)); });
    }
    rows.add("PLN-1", "oblique, cosine 1e-14", [] { return nearly_along_oblique(1e-14); });

    for (const double offset : {0.0, 1e6}) {
        const Plane plane{offset * Vec3(0.6, -0.48, 0.64), {0.1, 0.2, 3}};
        const std::string name = offset == 0 ? "plane" : "plane at 1e6";
        rows.add(
            "SPN-2", name,
            [=] { return only(plane, 1, [=](Random& random) { return at_plane(plane, random); }); },
            Criterion::spawned);
    }
    return rows.take();
}

std::vector<HardCase> plane_pair_cases() {
    const Plane lifted = raised(level, 1), other = oblique();
    Rows rows("scene");
    for (const int n : {1, 2, 8}) {
        const std::string apart = std::to_string(n) + " ulp apart";
        rows.add_in_float("PLN-2", apart,
                          [=] { return pair(lifted, raised(lifted, n * 0x1p-23)); });
        rows.add("PLN-2", apart, [=] { return pair(lifted, raised(lifted, n * 0x1p-52)); });
        rows.add_in_float("PLN-2", "oblique, " + apart,
                          [=] { return pair(other, raised(other, n * 0x1p-25)); });
        rows.add("PLN-2", "oblique, " + apart,
                 [=] { return pair(other, raised(other, n * 0x1p-54)); });
    }
    rows.add_both("PLN-2", "identical", [=] { return pair(other, other); });
    rows.add_both("PLN-2", "identical but for the normal's length", [=] {
        return pair(other, {other.point, 2.0 * other.normal});
    });
    return rows.take();
}

}  // namespace etalon::hard
