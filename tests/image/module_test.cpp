// Loading of the OpenImageIO module, and what happens if it cannot be loaded.
#include <sys/wait.h>
#include <unistd.h>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::StartsWith;

namespace {

bool has_openimageio() {
    return content_of("/proc/self/maps").find("libOpenImageIO") != std::string::npos;
}

/// The message of writing a PNG in a process of its own that looks for the module in `folder`.
std::string error_with_modules_in(const std::string& folder, const std::string& png) {
    int ends[2] = {};
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("ETALON_MODULE_PATH", folder.c_str(), 1);
        const std::string error = write_image(png, random_image(4, 3));
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
    REQUIRE(write_image(folder / "p.exr", image) == "");
    REQUIRE(read_image(folder / "p.exr").error == "");
    REQUIRE(read_image(folder / "none.png").error != "");
    CHECK_FALSE(has_openimageio());

    const std::string missing = error_with_modules_in(folder / ".", folder / "p.png");
    CHECK_THAT(missing, StartsWith(folder / "p.png") && ContainsSubstring("OpenImageIO module") &&
                            ContainsSubstring("no such file") &&
                            ContainsSubstring(folder / "./etalon_oiio.so"));
    put(folder / "etalon_oiio.so", "not a library");
    CHECK_THAT(error_with_modules_in(folder / ".", folder / "p.png"),
               ContainsSubstring("cannot be loaded") && ContainsSubstring("etalon_oiio.so"));
    CHECK_FALSE(std::filesystem::exists(folder / "p.png"));
    CHECK(error_with_modules_in(ETALON_BINARY_DIR "/lib", folder / "p.png") == "");
    CHECK(std::filesystem::exists(folder / "p.png"));

    CHECK_FALSE(has_openimageio());
    REQUIRE(write_image(folder / "q.png", image) == "");
    CHECK(has_openimageio());
    CHECK(content_of(folder / "p.png") == content_of(folder / "q.png"));
}
