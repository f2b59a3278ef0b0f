#include "core/color/cie_1931.h"

#include "tests/catch.h"

using namespace etalon;

namespace {

const Vec3& at(int wavelength) {
    return cie_1931()[static_cast<std::size_t>(wavelength - first_wavelength)];
}

}  // namespace

TEST_CASE("the matching functions are those of the CIE where it tabulates them in steps of 5 nm") {
    CHECK(at(360) == Vec3(0.0001299, 0.000003917, 0.0006061));
    CHECK(at(445) == Vec3(0.34806, 0.0298, 1.7826));
    CHECK(at(555) == Vec3(0.5120501, 1, 0.005749999));
    CHECK(at(600) == Vec3(1.0622, 0.631, 0.0008));
    CHECK(at(830) == Vec3(0.000001251141, 0.00000045181, 0));
}

TEST_CASE("between them the matching functions are those of its table in steps of 1 nm") {
    const auto check = [](int wavelength, const Vec3& expected) {
        CAPTURE(wavelength);
        CHECK(max_abs(at(wavelength) - expected) < 0.0002);
    };
    check(443, {0.350013, 0.0269586, 1.776264});
    check(447, {0.344262, 0.0328837, 1.781700});
    check(553, {0.480064, 0.999112, 0.0067854});
    check(599, {1.062910, 0.643845, 0.00084256});
}

TEST_CASE("the matching functions have the same integral, as the CIE makes them") {
    Vec3 sum(0);
    for (const Vec3& f : cie_1931()) sum += f;
    CHECK(sum.x == Approx(106.8655).epsilon(1e-5));
    CHECK(sum.y == Approx(106.8569).epsilon(1e-5));
    CHECK(sum.z == Approx(106.8922).epsilon(1e-5));
}
