// Libraries are loaded only for scenes that need them, as the mappings of the process show.
#include <cstdlib>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

namespace {

/// The dynamic linker's list of what a command loads, dlopen included.
std::string libraries(const Folder& f, const std::string& arguments) {
    const ProgramResult r = f.shell("LD_DEBUG=files " ETALON_BINARY_DIR "/bin/etalon " + arguments);
    CHECK(r.status == 0);
    return r.err;
}

/// A P3F scene with a skybox of grey faces, each with a file of another extension.
void write_skybox_scene(const Folder& f, const std::vector<std::string>& extensions) {
    std::filesystem::create_directory(f.path("sky"));
    const char* names[] = {"right", "left", "top", "bottom", "front", "back"};
    for (std::size_t k = 0; k < 6; ++k) {
        const std::string path = "sky/" + std::string(names[k]) + extensions[k];
        if (extensions[k] == ".hdr") {
            f.write(path, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n@@@\x81");
        } else if (extensions[k] == ".jpg") {
            std::filesystem::copy(ETALON_SOURCE_DIR "/docs/showcase.jpg", f.path(path));
        } else {
            const etalon::RenderedImage grey{
                32,   32, {{0, 0}, {31, 31}}, std::vector<etalon::Color>(1024, etalon::Color(0.5F)),
                true, {}};
            REQUIRE(etalon::write_image(f.path(path), grey) == "");
        }
    }
    f.write("sky.p3f", "env sky\n" + small_scene);
}

}  // namespace

TEST_CASE("EXR, PNG and JPEG need no OpenImageIO", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK_THAT(libraries(f, "info ball.p3f"), !ContainsSubstring("libOpenImageIO"));
    CHECK_THAT(libraries(f, "render ball.p3f -o a.exr -o a.png"),
               !ContainsSubstring("libOpenImageIO"));
    write_skybox_scene(f, {".jpg", ".jpg", ".jpg", ".png", ".png", ".exr"});
    const std::string loaded = libraries(f, "render sky.p3f --strict -o b.png");
    CHECK_THAT(loaded, !ContainsSubstring("libOpenImageIO"));
    CHECK_THAT(loaded, ContainsSubstring("libjpeg"));
    CHECK_THAT(libraries(f, "compare a.exr a.png"), !ContainsSubstring("libOpenImageIO"));
}

TEST_CASE("a process that no MPI launcher started loads no MPI", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string loaded = libraries(f, "render ball.p3f -o a.exr");
    CHECK_THAT(loaded, !ContainsSubstring("libmpi") && !ContainsSubstring("etalon_mpi"));
}

TEST_CASE("no program waits for Highway's library to measure a clock", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK_THAT(libraries(f, "render ball.p3f -o a.exr"), !ContainsSubstring("libhwy"));
}

TEST_CASE("a module that is missing is noticed before rendering", "[app]") {
    const Folder f;
    write_skybox_scene(f, {".jpg", ".hdr", ".png", ".png", ".png", ".exr"});
    CHECK_THAT(libraries(f, "render sky.p3f --strict -o a.png"),
               ContainsSubstring("libOpenImageIO"));
    const std::string without = "ETALON_MODULE_PATH=. " ETALON_BINARY_DIR "/bin/etalon ";
    const ProgramResult strict = f.shell(without + "render sky.p3f --strict -o b.png");
    CHECK(strict.status == 3);
    CHECK_THAT(strict.err, ContainsSubstring("left.hdr: cannot be read: the OpenImageIO module"));
    CHECK_FALSE(f.has("b.png"));
    const ProgramResult reference =
        f.shell(without + "render sky.p3f --reference sky/left.hdr -o b.png");
    CHECK(reference.status == 3);
    CHECK_FALSE(f.has("b.png"));
}

TEST_CASE("a damaged face does not lose the image", "[app]") {
    const Folder f;
    write_skybox_scene(f, {".png", ".png", ".png", ".png", ".png", ".png"});
    for (const char* name : {"sky/back.png", "sky/bottom.png"}) {
        f.write(name, f.read(name).substr(0, 120));
    }
    const ProgramResult usual = f.etalon("render sky.p3f -q -o a.png");
    CHECK(usual.status == 0);
    CHECK(f.has("a.png"));
    CHECK_THAT(usual.err, ContainsSubstring("back.png: cannot be read: ") &&
                              ContainsSubstring("the background colour stands in"));
    const ProgramResult strict = f.etalon("render sky.p3f -q --strict -o b.png");
    CHECK(strict.status == 3);
    CHECK(f.read("a.png") == f.read("b.png"));
}

TEST_CASE("Without /proc no library is loaded from the current folder", "[app][needs_unshare]") {
    const Folder f;
    const std::string without_proc = "unshare -rm sh -c 'mount -t tmpfs none /proc && ";
    SKIP_UNLESS(f.shell(without_proc + "true'").status == 0, "unshare is not allowed");
    SKIP_UNLESS(!is_sanitized, "sanitizers need /proc");
    f.shell("mkdir lib && cp '" ETALON_BINARY_DIR "/lib/fault_injection.so' lib/etalon_oiio.so");
    f.write("t.pgm", "P5 1 1 255\nx");
    f.write("s.pbrt",
            "Camera \"perspective\" WorldBegin Texture \"t\" \"spectrum\" \"imagemap\" \"string "
            "filename\" \"t.pgm\" Material \"matte\" \"texture Kd\" \"t\" Shape \"sphere\" "
            "WorldEnd\n");
    const ProgramResult r = f.shell(without_proc + ETALON_BINARY_DIR
                                    "/bin/etalon render s.pbrt -t 1 --spp 1 -q -o a.exr'");
    CHECK_THAT(r.err, ContainsSubstring("/proc/self/exe"));
}
