// Behaviour of the programs when a standard stream is full, closed or no longer read.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

const std::string programs = ETALON_BINARY_DIR "/bin/";

/// Folder with a scene, an image of it and a ray.
struct Used : Folder {
    Used() {
        write("ball.p3f", small_scene);
        write("rays.txt", "0 0 5 0 0 -1\n");
        REQUIRE(etalon("render ball.p3f -q -o whole.exr").status == 0);
    }
};

/// Commands that write results to standard output.
const std::string result_commands[] = {
    "etalon --help",
    "etalon --version",
    "etalon trace ball.p3f --rays rays.txt",
    "etalon info ball.p3f",
    "etalon info ball.p3f --json",
    "etalon compare whole.exr whole.exr",
    "etalon compare whole.exr whole.exr --json -",
    "etalon crosscheck ball.p3f -b bvh --rays 20",
    "etalon crosscheck ball.p3f -b bvh --rays 20 --json -",
    "etalon render ball.p3f -q --stats -",
    "etalon render ball.p3f -q -o -",
    "etalon convert ball.p3f -o -",
    "etalon-bench --help",
    "etalon-bench speed --list",
    "etalon-bench speed --scene spheres:20 --only-build --repeat 1",
    "etalon-bench speed --scene spheres:20 --only-build --repeat 1 --json -",
    "etalon-bench accuracy --list",
    "etalon-bench accuracy --case PLN-1 --rays 1 --backends bvh --only-backends",
    "etalon-bench frames ball.p3f --repeat 1",
    "etalon-bench convergence ball.p3f --spp 4 --seeds 1",
    "etalon-scenes --help",
    "etalon-scenes tetra --size 2"};

}  // namespace

TEST_CASE("A full, closed or unread log loses no image and stops nothing", "[app]") {
    const Used f;
    f.write("odd.p3f", small_scene + "sphere 1 2 3 4\n");  // warned of
    const std::string whole = f.read("whole.exr");
    for (const std::string log : {"2>/dev/full", "2>&-", "2>&- >&-", "2>&- >&- <&-"}) {
        INFO(log);
        const auto r =
            f.shell("rm -f a.exr; '" + programs + "etalon' render odd.p3f -o a.exr " + log);
        CHECK(r.status == 0);
        CHECK(r.out + r.err == "");
        CHECK(
            f.shell("'" + programs + "etalon' compare a.exr whole.exr --fail-above mse=0").status ==
            0);
    }
    const auto unread = f.shell("rm -f a.exr; '" + programs +
                                "etalon' render odd.p3f -o a.exr 2>&1 | true; test -e a.exr");
    CHECK(unread.status == 0);
}

TEST_CASE("A log that no one reads any more stops nothing", "[app]") {
    const Used f;
    f.write("odd.p3f", small_scene + "sphere 1 2 3 4\n");  // warned of
    const auto r =
        f.shell("mkfifo log; exec 3<>log; head -c 65536 /dev/zero >&3; timeout -s KILL 60 '" +
                programs + "etalon' render odd.p3f --spp 10000000 --time-limit 6 -o a.exr 2>log");
    CHECK(r.status == 0);
    CHECK(f.has("a.exr"));
}

TEST_CASE("A message goes into no file that was opened in place of a closed stream", "[app]") {
    const Used f;
    const std::string command = "'" + programs + "etalon' render ball.p3f -o ";
    REQUIRE(f.shell(command + "a.png 2>&- >&- <&-").status == 0);
    REQUIRE(f.shell(command + "b.png").status == 0);
    CHECK(f.read("a.png") == f.read("b.png"));
}

TEST_CASE("Results that standard output cannot take end with status 4 and the reason", "[app]") {
    const Used f;
    for (const std::string& command : result_commands) {
        INFO(command);
        const std::string line = "exec '" + programs + "'" + command;
        CHECK(f.shell(line).status == 0);
        const auto full = f.shell(line + " >/dev/full");
        CHECK(full.status == 4);
        CHECK_THAT(full.err,
                   ContainsSubstring("error: standard output: cannot be written: No space left"));
        const auto closed = f.shell(line + " >&-");
        CHECK(closed.status == 4);
        CHECK_THAT(closed.err,
                   ContainsSubstring("error: standard output: cannot be written: Bad file"));
        CHECK(f.shell(line + " >/dev/full 2>/dev/full").status == 4);
    }
}

TEST_CASE("An image or a scene goes to standard output as it goes to a file", "[app]") {
    const Used f;
    const auto exr = f.etalon("render ball.p3f -o -");
    CHECK(exr.status == 0);
    CHECK(exr.out == f.read("whole.exr"));
    CHECK_THAT(exr.err, ContainsSubstring("-> standard output"));
    REQUIRE(f.etalon("render ball.p3f -q -o whole.png").status == 0);
    CHECK(f.etalon("render ball.p3f -o - --output-format png -o b.exr --stats s.json").out ==
          f.read("whole.png"));
    CHECK(f.read("b.exr") == exr.out);
    for (const std::string format : {"p3f", "pbrt"}) {
        const std::string option = format == "p3f" ? "" : " --output-format pbrt";
        REQUIRE(f.etalon("convert ball.p3f -o again." + format).status == 0);
        const auto text = f.etalon("convert - -o -" + option, small_scene);
        CHECK(text.status == 0);
        CHECK(text.out == f.read("again." + format));
    }
}

TEST_CASE("Standard output takes one result, in a format that it can have", "[app]") {
    const Used f;
    const std::pair<std::string, std::string> cases[] = {
        {"render ball.p3f -o - --stats -", "only one output can be -, standard output"},
        {"render ball.p3f -o - -o -", "only one output can be -, standard output"},
        {"render ball.p3f -o a.exr --output-format png", "--output-format: no output is -"},
        {"render ball.p3f -o - --output-format gif", "expected one of exr, png"},
        {"render ball.p3f -o - --exposure 1", "--exposure: no output is a PNG"},
        {"render ball.p3f -o - --output-format png --aov N", "--aov: no output is an EXR"},
        {"convert ball.p3f -o a.p3f --output-format p3f", "--output-format: the output is not -"},
        {"convert ball.p3f -o a.obj", "expected a name ending in .pbrt or .p3f, or -"}};
    for (const auto& [command, error] : cases) {
        INFO(command);
        const auto r = f.etalon(command);
        CHECK(r.status == 2);
        CHECK(r.out == "");
        CHECK_THAT(r.err, ContainsSubstring(error));
    }
    CHECK_FALSE(f.has("a.exr"));
    CHECK(f.etalon("render ball.p3f -o - --output-format png --exposure 1").status == 0);
    CHECK(f.etalon("render ball.p3f -o - --aov N").status == 0);
}

TEST_CASE("A file to which a stream is redirected keeps what the stream wrote", "[app]") {
    const Used f;
    const std::string render = programs + "etalon render ball.p3f -q -o a.exr --stats ";
    f.write("log", "before\n");
    CHECK(f.shell(render + "/dev/stdout >>log; echo after >>log").status == 0);
    const std::string log = f.read("log");
    CHECK(log.rfind("before\n{\n", 0) == 0);
    CHECK_THAT(log, Catch::Matchers::EndsWith("}\nafter\n"));
    const std::pair<std::string, std::string> streams[] = {
        {"etalon trace ball.p3f --rays rays.txt -o /dev/stdout", ">both"},
        {"etalon trace ball.p3f --rays rays.txt -o /dev/stderr", "2>both >&2"},
        {"etalon trace ball.p3f --rays rays.txt -o /dev/fd/3", "3>both >&3"},
        {"etalon trace ball.p3f --rays rays.txt -o both", ">both"},
        {"etalon-scenes tetra --size 2 -o /dev/stdout", ">both"}};
    for (const auto& [command, redirected] : streams) {
        INFO(command);
        const std::string line = programs + command;
        REQUIRE(f.shell(line.substr(0, line.find(" -o ")) + " >alone").status == 0);
        CHECK(f.shell("{ echo before; " + line + "; echo after; } " + redirected).status == 0);
        CHECK(f.read("both") == "before\n" + f.read("alone") + "after\n");
    }
}

TEST_CASE("A limit of file sizes is reported like a full disk", "[app]") {
    const Used f;
    const std::string limited = "ulimit -c 0; ulimit -f 8; exec '" + programs +  // 4 KiB
                                "etalon' render ball.p3f -q ";
    const auto r = f.shell(limited + "-o big.exr --resolution 200x100");
    CHECK(r.status == 4);
    CHECK_THAT(r.err, ContainsSubstring("big.exr: cannot be written: File too large"));
    const auto kept = f.shell(limited +
                              "-o a.png --spp 2000 --checkpoint c --checkpoint-every 0.01"
                              " --time-limit 0.5");
    CHECK(kept.status == 0);
    CHECK_THAT(kept.err, ContainsSubstring("warning: checkpoint c: cannot be written: File too"));
    CHECK(f.shell("ls -A").out == "a.png\nball.p3f\nrays.txt\nwhole.exr\n");
}

TEST_CASE("The image is written even if its statistics cannot be", "[app]") {
    const Used f;
    for (const std::string out : {">/dev/full", ">&-", ">&- 2>&-"}) {
        INFO(out);
        const auto r = f.shell("rm -f a.exr; '" + programs +
                               "etalon' render ball.p3f -o a.exr --stats - " + out);
        CHECK(r.status == 4);
        CHECK(
            f.shell("'" + programs + "etalon' compare a.exr whole.exr --fail-above mse=0").status ==
            0);
    }
}

TEST_CASE("A full standard output does not hide that the arguments or the scene are wrong",
          "[app]") {
    const Used f;
    CHECK(f.etalon("trace ball.p3f >/dev/full").status == 2);
    CHECK(f.etalon("info missing.p3f --json >/dev/full").status == 3);
    CHECK(f.etalon("render ball.p3f -o a.exr >/dev/full").status == 0);  // it prints no result
}

TEST_CASE("Everything that is written to a standard stream goes through the console", "[app]") {
    const Folder f;
    const auto r = f.shell(
        "cd '" ETALON_SOURCE_DIR
        "' && grep -rnE "
        "'fmt::print|std::(cout|cerr|clog|puts|printf)|std(out|err)\\b|write(_all)?.STD' "
        "app bench core embree_backend native_accel scenes --include='*.cpp' --include='*.h'");
    for (std::size_t at = 0; at < r.out.size(); at = r.out.find('\n', at) + 1) {
        CHECK(r.out.compare(at, 23, "app/common/console.cpp:") == 0);
    }
    CHECK_THAT(r.out, ContainsSubstring("app/common/console.cpp:"));
}
