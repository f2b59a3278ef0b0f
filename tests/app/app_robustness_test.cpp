// Malformed input: a diagnostic or an image, never a crash, a hang, or memory far beyond the file's
// size.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

std::uint32_t next(std::uint32_t& state) {
    return state = state * 1664525U + 1013904223U;
}

/// Renders a small image with default options; the exit status must be a documented one.
void must_survive(const Folder& f, const std::string& text) {
    f.write("bad.p3f", text);
    const auto r = f.shell("ulimit -t 20; exec " ETALON_BINARY_DIR
                           "/bin/etalon render bad.p3f --resolution 8x6 --spp 0 -q -o bad.exr");
    INFO(r.err);
    CHECK((r.status == 0 || r.status == 3));
    if (r.status == 3) CHECK(r.err != "");
}

}  // namespace

TEST_CASE("Truncated and damaged scenes end with a diagnostic or an image", "[app]") {
    const Folder f;
    std::uint32_t state = 1;
    for (int i = 0; i < 15; ++i)
        must_survive(f, small_scene.substr(0, next(state) % small_scene.size()));
    for (int i = 0; i < 30; ++i) {
        std::string text = small_scene;
        text[next(state) % text.size()] = static_cast<char>(next(state) >> 24);
        must_survive(f, text);
    }
}

TEST_CASE("Truncated and damaged scenes end with a diagnostic or an image, many", "[long]") {
    const Folder f;
    std::uint32_t state = 2;
    for (int i = 0; i < 100; ++i)
        must_survive(f, small_scene.substr(0, next(state) % small_scene.size()));
    for (int i = 0; i < 1000; ++i) {
        std::string text = small_scene;
        text[next(state) % text.size()] = static_cast<char>(next(state) >> 24);
        must_survive(f, text);
    }
}

TEST_CASE("Numbers out of range and huge counts are diagnosed at no cost", "[app]") {
    const Folder f;
    for (const char* bad :
         {"s nan 0 0 1\n", "s 1e400 0 0 1\n", "s 0 0 0 inf\n", "p 2000000000\n1 2 3\n",
          "mesh 1000000000 1000000000\n0 0 0\n", "mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2 9\n"}) {
        INFO(bad);
        f.write("bad.p3f", small_scene + bad);
        const auto r = f.etalon("render bad.p3f -q -o bad.exr");
        CHECK(r.status == 0);
        CHECK(r.err != "");
        CHECK(r.peak_bytes < (1U << 29));
    }
}
