#include "core/texture/packed_colors.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

TEST_CASE("Packed colours are off by a thousandth of their largest channel", "[texture]") {
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const double scale = std::exp2(random.uniform(-8, 0.99));
        const Color c(Vec3(random.uniform(), random.uniform(), random.uniform()) * scale);
        const float largest = std::max({c.x, c.y, c.z});
        const Color found = unpacked(packed(c));
        const float bound = std::max(largest * 0x1.01p-10F, 0x1p-13F);
        for (int k = 0; k < 3; ++k) CHECK(std::abs(found[k] - c[k]) <= bound);
    }
}

TEST_CASE("Some colours are packed as they are", "[texture]") {
    for (const float x : {0.0F, 1.0F, 0.5F, 0x1p-12F, 0x1.ffp0F}) {
        CHECK(unpacked(packed(Color(x))) == Color(x));
    }
    CHECK(unpacked(packed({1, 0.25F, 0})) == Color(1, 0.25F, 0));
    CHECK(unpacked(packed(Color(0.9999F))) == Color(1));        // rounds up to the next unit
    CHECK(unpacked(packed(Color(1e9F))) == Color(0x1.ff8p0F));  // the brightest
    CHECK(unpacked(packed({-1, 0.5F, 1e-12F})) == Color(0, 0.5F, 0));
}
