#include "tests/color/copper.h"

#include "tests/color/near_color.h"

using namespace etalon;

namespace {

/// Returns the reflectance of a metal at normal incidence.
double reflected(double n, double k) {
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

}  // namespace

// PBRT v3's default metal has another table of the same measurements, smoothed and rounded.

TEST_CASE("copper is the default metal of PBRT v3") {
    is_near(copper_eta(), {0.19999069F, 0.92208463F, 1.09987593F}, 0.002);
    is_near(copper_k(), {3.90463543F, 2.44763327F, 2.13765264F}, 0.001);
}

TEST_CASE("copper reflects what the default metal of PBRT v3 does, to 1 in 500") {
    const Color n = copper_eta(), k = copper_k();
    CHECK(reflected(n.x, k.x) == Approx(reflected(0.19999069, 3.90463543)).epsilon(0.002));
    CHECK(reflected(n.y, k.y) == Approx(reflected(0.92208463, 2.44763327)).epsilon(0.002));
    CHECK(reflected(n.z, k.z) == Approx(reflected(1.09987593, 2.13765264)).epsilon(0.002));
}
