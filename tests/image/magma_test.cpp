#include "core/image/metrics/magma.h"

#include <limits>

#include "tests/catch.h"

using namespace etalon;

namespace {

using Bytes = std::array<std::uint8_t, 3>;

double brightness(const Bytes& c) {
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

}  // namespace

TEST_CASE("magma has its published colours, each where its number is nearest") {
    CHECK(magma(0) == Bytes{0, 0, 4});
    CHECK(magma(0.25) == Bytes{81, 18, 124});
    CHECK(magma(0.5) == Bytes{183, 55, 121});
    CHECK(magma(0.75) == Bytes{251, 135, 97});
    CHECK(magma(1) == Bytes{252, 253, 191});
    CHECK(magma(-1) == magma(0));
    CHECK(magma(2) == magma(1));
}

TEST_CASE("magma gets monotonically brighter") {
    for (int i = 0; i + 1 < 256; ++i) {
        INFO(i);
        const double rounding = 0.5;
        CHECK(brightness(magma((i + 1) / 255.0)) > brightness(magma(i / 255.0)) - rounding);
        if (i + 4 < 256) {
            CHECK(brightness(magma((i + 4) / 255.0)) > brightness(magma(i / 255.0)) + rounding);
        }
    }
}
