// Loading of the OpenImageIO module, and what happens if it cannot be loaded.
#include <sys/wait.h>
#include <unistd.h>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/encoded_files.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::StartsWith;

namespace {

bool has_openimageio() {
    return content_of("/proc/self/maps").find("libOpenImageIO") != std::string::npos;
}

/// Returns the message of reading a file in a separate process that looks for the module in
/// `folder`.
std::string error_with_modules_in(const std::string& folder, const std::string& path) {
    int ends[2] = {};
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("ETALON_MODULE_PATH", folder.c_str(), 1);
        const std::string error = read_image(path, Extent::header).error;
        const bool sent = ::write(ends[1], error.data(), error.size()) >= 0;
        ::_exit(sent ? 0 : 1);
    }
    ::close(ends[1]);
    std::string error(4096, 0);
    const ssize_t size = ::read(ends[0], error.data(), error.size());
    ::close(ends[0]);
    int status = -1;
    ::waitpid(child, &status, 0);
    CHECK(status == 0);
    error.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return error;
}

}  // namespace

TEST_CASE("OpenImageIO is loaded by the first call that needs it, and not before") {
    const TemporaryFolder folder;
    const RenderedImage image = random_image(4, 3);
    CHECK_FALSE(has_openimageio());
    for (const char* name : {"p.exr", "p.png"}) {
        REQUIRE(write_image(folder / name, image) == "");
        REQUIRE(read_image(folder / name).error == "");
    }
    put(folder / "p.jpg", encoded_jpeg({}, 4, 3));
    REQUIRE(read_image(folder / "p.jpg").error == "");
    REQUIRE(read_image(folder / "none.pgm").error != "");
    CHECK_FALSE(has_openimageio());

    const std::string path = folder / "p.pgm";
    put(path, "P5 1 1 255\nx");
    const std::string missing = error_with_modules_in(folder / ".", path);
    CHECK_THAT(missing, StartsWith(path + ": cannot be read: the OpenImageIO module") &&
                            ContainsSubstring("no such file") &&
                            ContainsSubstring(folder / "./etalon_oiio.so"));
    put(folder / "etalon_oiio.so", "not a library");
    CHECK_THAT(error_with_modules_in(folder / ".", path),
               ContainsSubstring("cannot be loaded") && ContainsSubstring("etalon_oiio.so"));
    CHECK_THAT(error_with_modules_in("", path),
               ContainsSubstring("ETALON_MODULE_PATH is empty; expected a folder"));
    CHECK(error_with_modules_in(ETALON_BINARY_DIR "/lib", path) == "");

    CHECK_FALSE(has_openimageio());
    REQUIRE(read_image(path).error == "");
    CHECK(has_openimageio());
}
