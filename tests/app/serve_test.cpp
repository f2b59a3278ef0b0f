// etalon serve: the page with the image as it converges.
#include <algorithm>

#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

namespace {

/// Runs a script of this folder, which ends with status 1 and says where if anything is wrong.
ProgramResult run_script(const Folder& f, const std::string& name, const std::string& more = "") {
    return f.shell("PYTHONDONTWRITEBYTECODE=1 python3 " ETALON_SOURCE_DIR "/tests/app/" + name +
                   " " ETALON_BINARY_DIR "/bin/etalon " + more);
}

bool has_python(const Folder& f) {
    return f.shell("python3 -c 'import sys; sys.exit(sys.version_info < (3, 8))'").status == 0;
}

}  // namespace

TEST_CASE("serve shows its image only to clients with the address", "[app][needs_python]") {
    const Folder f;
    SKIP_UNLESS(has_python(f), "no Python 3.8 or newer");
    f.write("ball.p3f", small_scene);
    // A sanitizer has several bytes of its own for each that the program touches.
    const auto r = run_script(f, "serve_client.py", is_sanitized ? "3e8" : "3e7");
    INFO(r.out << r.err);
    CHECK(r.status == 0);
}

TEST_CASE("Chromium shows an image as it converges, and its button ends the rendering",
          "[app][needs_chromium]") {
    const Folder f;
    SKIP_UNLESS(has_python(f), "no Python 3.8 or newer");
    SKIP_UNLESS(f.shell("chromium --version").status == 0, "no Chromium that runs");
    f.write("ball.p3f", small_scene);
    const auto r = run_script(f, "serve_browser.py", "chromium");
    INFO(r.out << r.err);
    CHECK(r.status == 0);
}

TEST_CASE("serve without clients ends with the image that render writes", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r =
        f.etalon("serve ball.p3f -q --spp 8 --filter gaussian:2 -o a.exr --stats a.json");
    CHECK(r.status == 0);
    CHECK(r.err == "");
    CHECK_THAT(r.out, ContainsSubstring("http://127.0.0.1:"));
    CHECK(std::count(r.out.begin(), r.out.end(), '\n') == 1);
    REQUIRE(f.etalon("render ball.p3f -q --spp 8 --filter gaussian:2 -o b.exr").status == 0);
    CHECK(f.etalon("compare a.exr b.exr --fail-above different_pixels=0").status == 0);
    CHECK_THAT(f.read("a.json"), ContainsSubstring("\"expected_error\": {\n    \"relmse\": null"));
}

TEST_CASE("serve rejects standard output for files", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const std::string output : {"-o -", "-o a.exr --stats -"}) {
        const auto r = f.etalon("serve ball.p3f " + output);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("standard output has the address of the page"));
    }
}

TEST_CASE("serve ends with an image or a message when memory is short", "[app]") {
    if (is_sanitized) return;  // takes more than the limits at once
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const int megabytes : {1, 5, 10, 15, 20, 30, 40, 60, 80, 120}) {
        const auto r =
            f.etalon("serve ball.p3f -q --resolution 64x64 --spp 4 -o a.exr --max-memory " +
                     std::to_string(megabytes) + "M");
        CAPTURE(megabytes, r.status, r.err);
        CHECK((r.status == 0 || r.status == 3 || r.status == 4));
        if (r.status != 0) CHECK_THAT(r.err, ContainsSubstring("error: "));
    }
}
