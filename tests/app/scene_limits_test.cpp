// Limits for untrusted scenes: they open no files outside a folder and use no more memory than
// allowed.
#include <filesystem>
#include <string>

#include "app/common/memory_limit.h"
#include "core/scene/shapes.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// A PBRT scene whose line 3 holds `world`.
std::string pbrt_scene(const std::string& world) {
    return "Camera \"perspective\" Film \"image\" \"integer xresolution\" 8 \"integer "
           "yresolution\" 8\nWorldBegin\n" +
           world + "\nShape \"sphere\"\nWorldEnd\n";
}

std::string sce_scene(const std::string& mesh) {
    return "sphere\nobject_flat " + mesh + "\nend\n";
}

std::string p3f_scene(const std::string& sky) {
    return "env " + sky + "\n" + small_scene;
}

/// Folders "in" and "in-side", the second of which a scene in the first must not reach.
struct TwoFolders {
    TwoFolders() {
        std::filesystem::create_directories(f.path("in/sub"));
        std::filesystem::create_directories(f.path("in-side"));
        f.write("in-side/secret", "root:x:0:0\n");
        f.write("in/sub/own.pbrt", "Shape \"sphere\"\n");
    }

    /// Loads it as in/NAME, confined to "in".
    ProgramResult confined(const std::string& name, const std::string& text) const {
        f.write("in/" + name, text);
        return f.etalon("info in/" + name + " --root in");
    }

    void check_refused(const std::string& name, const std::string& text, const std::string& place,
                       const std::string& file) const {
        INFO(text);
        const ProgramResult r = confined(name, text);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring("in/" + name + ":" + place + ": error: '" + file +
                                            "' lies outside of 'in', where alone files may be"));
        CHECK_THAT(r.err, !ContainsSubstring("x:0:0"));
    }

    Folder f;
};

}  // namespace

TEST_CASE("A confined PBRT scene opens no file outside of the folder", "[app][limits]") {
    const TwoFolders two;
    const auto check = [&](const std::string& world, const std::string& column,
                           const std::string& file) {
        two.check_refused("a.pbrt", pbrt_scene(world), "3:" + column, file);
    };
    check("Include \"../in-side/secret\"", "1", "in-side/secret");
    check("Include \"/proc/self/environ\"", "1", "/proc/self/environ");
    check("Include \"/no/such/file\"", "1", "/no/such/file");
    check("Include \"sub/../../in-side/secret\"", "1", "in-side/secret");
    check("Shape \"plymesh\" \"string filename\" \"../in-side/secret\"", "17", "in-side/secret");
    check("LightSource \"infinite\" \"string mapname\" \"../in-side/secret\"", "24",
          "in-side/secret");
    check("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"../in-side/secret\"", "32",
          "in-side/secret");
    check("Material \"matte\" \"spectrum Kd\" \"../in-side/secret\"", "18", "in-side/secret");
    const ProgramResult lens =
        two.confined("b.pbrt",
                     "Camera \"realistic\" \"string lensfile\" \"../in-side/secret\"\nWorldBegin\n"
                     "Shape \"sphere\" WorldEnd");
    CHECK(lens.status == 3);
    CHECK_THAT(lens.err, ContainsSubstring("in/b.pbrt:1:20: error: 'in-side/secret' lies outside"));
}

TEST_CASE("Confined SCE and P3F scenes open no file outside of the folder", "[app][limits]") {
    const TwoFolders two;
    two.check_refused("a.sce", sce_scene("../in-side/secret"), "2:13", "in/../in-side/secret");
    two.check_refused("a.p3f", p3f_scene("../in-side"), "1:1", "in/../in-side/right.jpg");
}

TEST_CASE("A symbolic link cannot lead out of the folder", "[app][limits]") {
    const TwoFolders two;
    std::filesystem::create_symlink("../in-side/secret", two.f.path("in/link"));
    std::filesystem::create_directory_symlink("../in-side", two.f.path("in/door"));
    two.check_refused("a.pbrt", pbrt_scene("Include \"link\""), "3:1", "in/link");
    two.check_refused("a.pbrt", pbrt_scene("Include \"door/secret\""), "3:1", "in/door/secret");
    two.check_refused("a.sce", sce_scene("link"), "2:13", "in/link");
}

TEST_CASE("A confined scene opens the files of the folder", "[app][limits]") {
    const TwoFolders two;
    std::filesystem::create_directory_symlink("sub", two.f.path("in/inner"));
    for (const char* name : {"sub/own.pbrt", "inner/own.pbrt", "sub/../sub/own.pbrt"}) {
        const ProgramResult r =
            two.confined("a.pbrt", pbrt_scene(std::string("Include \"") + name + '"'));
        CHECK(r.status == 0);
        CHECK(r.err.empty());
    }
    // The scene file itself is not restricted, and may be reached through a link.
    std::filesystem::create_directory_symlink("in", two.f.path("way"));
    two.f.write("in/a.pbrt", pbrt_scene("Include \"sub/own.pbrt\""));
    CHECK(two.f.etalon("info way/a.pbrt --root in").status == 0);
    CHECK(two.f.etalon("info in/a.pbrt --root way").status == 0);
}

TEST_CASE("A root that is no folder is wrong usage", "[app][limits]") {
    const TwoFolders two;
    for (const char* root : {"none", "in-side/secret"}) {
        const ProgramResult r = two.f.etalon(std::string("info x.pbrt --root ") + root);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("expected a directory"));
    }
}

TEST_CASE("A size is a number and a unit", "[app][limits]") {
    CHECK(parse_bytes("512") == 512);
    CHECK(parse_bytes("500M") == 500e6);
    CHECK(parse_bytes("4 GB") == 4e9);
    CHECK(parse_bytes("1.5GiB") == 1.5 * 1024 * 1024 * 1024);
    CHECK(parse_bytes("2KiB") == 2048);
    for (const char* bad : {"", "M", "0", "-1G", "1e3", "4Q", "4GBs", "inf", "nan", "1 2", "4g"}) {
        INFO(bad);
        CHECK(!parse_bytes(bad));
    }
    const Folder f;
    const ProgramResult r = f.etalon("info x.p3f --max-memory much");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, ContainsSubstring("much: expected a size as 500M, 4G or 1.5GiB"));
}

#ifndef ETALON_SANITIZED  // a sanitizer ends the program itself where memory ends

TEST_CASE("An image that needs more than --max-memory is refused before it is begun",
          "[app][limits]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    const ProgramResult r = f.etalon("render a.p3f --resolution 9000x9000 --max-memory 500M");
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring("9000 x 9000 pixels need"));
    CHECK_THAT(r.err, ContainsSubstring("--max-memory"));
    CHECK(r.peak_bytes < 100'000'000);
}

TEST_CASE("The memory of channels, and of a part's film, is known before the image is begun",
          "[app][limits]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    const std::string render = "render a.p3f --resolution 1500x1500 --spp 1 -t 1 -q -o a.exr ";
    for (const std::string more :
         {"--max-memory 400M --aov albedo,N,P,Z,uv,dpdu,dpdv,primitiveId,instanceId,sampleCount",
          "--max-memory 200M --part 1/1"}) {
        const ProgramResult r = f.etalon(render + more);
        CAPTURE(more);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring("1500 x 1500 pixels need"));
    }
}

TEST_CASE("A scene that needs more than --max-memory is an error", "[app][limits]") {
    const Folder f;
    constexpr int count = 100'000;
    std::string text = small_scene;
    for (int i = 0; i < count; ++i) text += "s " + std::to_string(i) + " 0 0 1\n";
    f.write("a.p3f", text);
    CHECK(f.etalon("render a.p3f --max-memory 300M -t 1 -q -o a.exr").status == 0);
    for (const char* size : {"1M", "3M", "6M", "9M", "12M", "15M", "19M", "25M"}) {
        const bool is_too_small = parse_bytes(size) < count * sizeof(Sphere);
        for (const char* backend : {"bvh", "grid", "embree", "embree-user"}) {
            INFO(size << ' ' << backend);
            const ProgramResult r =
                f.shell(std::string("ulimit -t 60; exec " ETALON_BINARY_DIR
                                    "/bin/etalon render a.p3f -t 1 -q -o b.exr -b ") +
                        backend + " --max-memory " + size);
            CHECK(f.has("b.exr") == (r.status == 0));
            std::filesystem::remove(f.path("b.exr"));
            if (r.status == 0 && !is_too_small) continue;
            CHECK(r.status == 3);
            CHECK_THAT(r.err, ContainsSubstring("memory"));
        }
    }
}

#endif
