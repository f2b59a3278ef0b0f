// The map of costs that etalon serve shows.
#include "app/live/cost_map.h"

#include "core/image/io.h"
#include "core/image/metrics/magma.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("A map of costs is logarithmic: a 256th of the highest cost is black", "[app]") {
    const Folder f;
    const std::vector<double> costs = {512, 128, 32, 8, 2, 1, 0.01, 0};
    const double shown[] = {1, 0.75, 0.5, 0.25, 0, 0, 0, 0};
    f.write("map.png", cost_map({{3, 5}, {6, 6}}, costs));
    const auto read = read_image(f.path("map.png"));
    REQUIRE(read.error == "");
    const Image& map = read.value;
    REQUIRE(map.width == 4);
    REQUIRE(map.height == 2);
    for (int i = 0; i < 8; ++i) {
        const auto expected = magma(shown[i]);
        const Color color = map.color(i % 4, i / 4);
        CAPTURE(costs[i]);
        for (int k = 0; k < 3; ++k) CHECK(255 * color[k] == Approx(expected[k]));
    }
}
