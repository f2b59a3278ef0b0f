// Messages of etalon's commands about missing, too large or ignored input.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/image/encoded_files.h"
#include "tests/sanitized.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

const Folder& folder() {
    static const Folder f;
    static const std::string written = f.write("ball.p3f", small_scene);
    return f;
}

/// Returns the message of a failing command.
std::string error_of(const std::string& arguments, int status) {
    const auto r = folder().etalon(arguments);
    INFO(arguments);
    CHECK(r.status == status);
    CHECK(r.out == "");
    return r.err;
}

}  // namespace

TEST_CASE("an impossible image size is an error with the possible range", "[app]") {
    CHECK(error_of("render ball.p3f --resolution 100000x100000", 2) ==
          "etalon: error: --resolution 100000x100000: expected at most 65536 pixels a side\n");
    if (is_sanitized) return;  // reserves more addresses than the limit
    const auto r = folder().shell("ulimit -v 4000000; " ETALON_BINARY_DIR
                                  "/bin/etalon render ball.p3f --resolution 60000x50000 -o a.exr");
    CHECK(r.status == 3);
    CHECK(r.err ==
          "etalon: error: 60000 x 50000 pixels need 120.0 GB; the program may take "
          "4.1 GB (--max-memory)\n");
}

TEST_CASE("an exposure that no output has is refused", "[app]") {
    CHECK_THAT(error_of("render ball.p3f --exposure 1", 2),
               ContainsSubstring("expected -o FILE.png"));
    CHECK_THAT(error_of("render ball.p3f --exposure 1 -o a.exr", 2),
               ContainsSubstring("expected -o FILE.png"));
    CHECK(folder().etalon("render ball.p3f --exposure 1 -q -o a.exr -o a.png").status == 0);
}

TEST_CASE("the shading of another format's program is refused with both formats", "[app]") {
    CHECK(error_of("render ball.p3f --legacy sce", 2) ==
          "etalon: error: --legacy sce: expected a scene of sce, found one of p3f\n");
}

TEST_CASE("an empty value is shown as one", "[app]") {
    CHECK_THAT(error_of("render ball.p3f -o ''", 2),
               ContainsSubstring("error: --output '': expected a value\n"));
    CHECK_THAT(error_of("render ''", 2), ContainsSubstring("error: SCENE '': expected a value\n"));
}

TEST_CASE("an input that cannot be read is named with the system's reason", "[app]") {
    CHECK(error_of("trace ball.p3f --rays none.txt", 3) ==
          "none.txt: error: cannot be opened: No such file or directory\n");
    CHECK(error_of("trace ball.p3f --rays .", 3) == ".: error: is a directory\n");
    folder().write("text.txt", "no image\n");
    CHECK_THAT(
        error_of("compare text.txt text.txt", 3),
        ContainsSubstring(
            "text.txt: cannot be read: it is not an image; expected EXR, PNG, JPEG, HDR or PFM\n"));
}

TEST_CASE("a damaged image is reported with its format, without a library's message", "[app]") {
    const Folder& f = folder();
    REQUIRE(f.etalon("render ball.p3f -q -o whole.exr -o whole.png").status == 0);
    f.write("whole.jpg", encoded_jpeg({}, 40, 40));
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 24 +X 32\n";
    f.write("whole.hdr", hdr.append(4 * 24 * 32, 'x'));
    const std::pair<std::string, std::string> formats[] = {
        {"exr", "the EXR is damaged or cut short\n"},
        {"png", "the PNG is damaged or cut short\n"},
        {"jpg", "the JPEG is damaged or cut short\n"},
        {"hdr", "the HDR is damaged, cut short or of a kind not supported\n"}};
    for (const auto& [extension, reason] : formats) {
        const std::string whole = f.read("whole." + extension), name = "damaged." + extension;
        CHECK(f.etalon("compare whole." + extension + " whole." + extension).status == 0);
        const auto says = [&](const std::string& content, const std::string& expected) {
            INFO(name << " of " << content.size() << " bytes");
            f.write(name, content);
            CHECK(error_of("compare " + name + " whole.exr", 3) ==
                  "etalon: error: " + name + ": cannot be read: " + expected);
        };
        for (const std::size_t percent : {20, 50, 95}) {
            says(whole.substr(0, whole.size() * percent / 100), reason);
        }
        says(whole.substr(0, 12) + std::string(whole.size(), '\x5a'), reason);
        says("", "the file is empty\n");
        says(std::string(5000, '\x5a'),
             "it is not an image; expected EXR, PNG, JPEG, HDR or PFM\n");
    }
}

TEST_CASE("an output that cannot be written is named with the reason", "[app]") {
    CHECK(error_of("render ball.p3f -o no/x.exr", 4) ==
          "etalon: error: no/x.exr: cannot be written: no is not a directory\n");
}

TEST_CASE("a folder without permission is said to be that", "[app][needs_unprivileged_user]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("chmod 555 .");
    const std::string user =
        geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    const std::string as_user = user + "'" ETALON_BINARY_DIR "/bin/etalon' ";
    SKIP_UNLESS(f.shell(as_user + "info ball.p3f").status == 0,
                "root cannot run the program as another user");
    const auto r = f.shell(as_user + "render ball.p3f -o x.exr");
    f.shell("chmod 755 .");  // so that the folder can be removed
    CHECK(r.status == 4);
    CHECK(r.err == "etalon: error: x.exr: cannot be written: no permission in this folder\n");
}

TEST_CASE("the summary of a small image shows its rays and its time, not zeros", "[app]") {
    const auto r = folder().etalon("render ball.p3f -b bvh -o a.exr");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring(" rays in ") && ContainsSubstring(" ms -> a.exr"));
    CHECK_THAT(r.err, !ContainsSubstring("0.00"));
}

TEST_CASE("a scene truncated before its first shape is reported to have none", "[app]") {
    const Folder f;
    f.write("cut.p3f", small_scene.substr(0, small_scene.find("pl 1")));
    const auto r = f.etalon("info cut.p3f");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("cut.p3f: warning: no shapes"));
    CHECK(f.etalon("render cut.p3f --strict -o a.exr").status == 3);
    CHECK(f.etalon("render cut.p3f -q -o a.exr").status == 0);
}

TEST_CASE("info counts the diagnostics that it left out", "[app]") {
    const Folder f;
    std::string text = small_scene;
    for (int i = 0; i < 25; ++i) text += "s 0 0 0 nan\n";
    f.write("odd.p3f", text);
    const json list = json::parse(f.etalon("info odd.p3f --json").out)["diagnostics"];
    REQUIRE(list.size() == 20);
    CHECK(list.back()["more"] == 5);
    CHECK_FALSE(list.front().contains("more"));
    CHECK_THAT(f.etalon("info odd.p3f").out, ContainsSubstring("diagnostics 25\n"));
    CHECK(f.etalon("info odd.p3f --json --legacy sce").out == "");  // wrong usage, no scene
}

TEST_CASE("JSON on standard output is alone there, and two results are refused", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q -o a.exr").status == 0);
    const std::string checked = "crosscheck ball.p3f -b bvh --rays 10 ";
    for (const std::string& command : {std::string("compare a.exr a.exr"), checked}) {
        const auto r = f.etalon(command + " --json -");
        CHECK(r.status == 0);
        CHECK(json::accept(r.out));
        CHECK(r.err != "");
    }
    CHECK(f.etalon(checked + "--json - --rays-out -").status == 2);
    const auto cases =
        f.shell(ETALON_BINARY_DIR "/bin/etalon-bench accuracy --case SPH-1 --rays 10 --json -");
    CHECK(json::accept(cases.out));
    CHECK(cases.err != "");
    CHECK(f.shell(ETALON_BINARY_DIR
                  "/bin/etalon-bench accuracy --case SPH-1 --rays 10 --json - --markdown -")
              .status == 2);
}
