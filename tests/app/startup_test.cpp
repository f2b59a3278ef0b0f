// A scene pays for what it contains: what is mapped into the process tells.
#include <cstdlib>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

/// The dynamic linker's list of what a command loads, dlopen included.
std::string libraries(const Folder& f, const std::string& arguments) {
    return f.shell("LD_DEBUG=files " ETALON_BINARY_DIR "/bin/etalon " + arguments).err;
}

}  // namespace

TEST_CASE("info and an EXR render of an untextured scene load no OpenImageIO", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK_THAT(libraries(f, "info ball.p3f"), !ContainsSubstring("libOpenImageIO"));
    CHECK_THAT(libraries(f, "render ball.p3f -o a.exr"), !ContainsSubstring("libOpenImageIO"));
    CHECK_THAT(libraries(f, "render ball.p3f -o a.png"), ContainsSubstring("libOpenImageIO"));
}
