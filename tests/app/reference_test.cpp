// Compares every feature scene with a small stored image. After an intended change, run this test
// with ETALON_UPDATE_REFERENCES=1, which rewrites the images and fails, and review them in the
// commit.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;
namespace fs = std::filesystem;

namespace {

const fs::path scenes = fs::path(ETALON_SOURCE_DIR) / "scenes" / "features";
const fs::path references = fs::path(ETALON_SOURCE_DIR) / "tests" / "references";

/// Counts pixels that differ by more than 1e-4 in a channel. Another libm may round a camera ray or
/// a highlight differently, which changes the last digits everywhere but hardly any edge.
int different_pixels(const std::vector<float>& a, const std::vector<float>& b) {
    int count = 0;
    for (std::size_t i = 0; i + 2 < a.size(); i += 3) {
        const auto differs = [&](std::size_t k) { return !(std::abs(a[k] - b[k]) <= 1e-4F); };
        if (differs(i) || differs(i + 1) || differs(i + 2)) ++count;
    }
    return count;
}

}  // namespace

TEST_CASE("Every feature scene looks as its stored reference", "[app]") {
    const Folder f;
    const bool update = std::getenv("ETALON_UPDATE_REFERENCES") != nullptr;
    int count = 0;
    for (const auto& entry : fs::directory_iterator(scenes)) {
        if (entry.path().extension() != ".p3f") continue;
        const std::string name = entry.path().stem().string();
        INFO(name);
        REQUIRE(f.etalon("render '" + entry.path().string() +
                         "' --resolution 60x40 --spp 2 --display-values -q -o now.exr")
                    .status == 0);
        const fs::path reference = references / (name + ".exr");
        if (update) fs::copy(f.path("now.exr"), reference, fs::copy_options::overwrite_existing);
        REQUIRE(fs::exists(reference));
        const auto expected = pixels(reference.string());
        const auto now = pixels(f.path("now.exr"));
        REQUIRE(now.size() == expected.size());
        CHECK(different_pixels(now, expected) <= 4);
        ++count;
    }
    CHECK(count >= 15);
    if (update) FAIL("the references were rewritten: compare without ETALON_UPDATE_REFERENCES");
}
