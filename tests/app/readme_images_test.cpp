// The images of the README against the scenes that they show.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

TEST_CASE("The README's images: given the scenes that they show, then renderings look alike",
          "[app]") {
    const std::pair<std::string, std::string> images[] = {
        {"scenes/showcase.p3f", "docs/showcase.jpg"},
        {"scenes/pbrt/still_life.pbrt", "docs/still_life.png"}};
    const std::string source = ETALON_SOURCE_DIR "/";
    for (const auto& [scene, image] : images) {
        INFO(image);
        const Folder f;
        REQUIRE(f.etalon("render '" + source + scene + "' --spp 1 -q -o now.png").status == 0);
        // The noise of one sample is half of that; another camera makes it twice as much.
        const auto r = f.etalon("compare now.png '" + source + image + "' --fail-above relmse=0.3");
        CHECK(r.err == "");
    }
}
