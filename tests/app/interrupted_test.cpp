// Results that long commands keep when they are interrupted.
#include <nlohmann/json.hpp>

#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

using nlohmann::json;

TEST_CASE("A signal while the scene is read ends the program", "[app]") {
    const Folder f;
    f.shell("mkfifo pipe.p3f");
    for (const std::string command : {"render pipe.p3f -o a.exr", "crosscheck pipe.p3f"}) {
        const auto r =
            f.shell("timeout -k 9 -s TERM 0.5 '" ETALON_BINARY_DIR "/bin/etalon' " + command);
        INFO(command);
        CHECK(r.status == 124);  // and not 137, after SIGKILL
        CHECK_FALSE(f.has("a.exr"));
    }
}

TEST_CASE("An interrupted crosscheck keeps the oracle's results", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = interrupted(
        f, "etalon crosscheck ball.p3f -b bvh,grid --rays 8000000 --json c.json", has_worked(200));
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("Stopped by a signal"));
    const json j = json::parse(f.read("c.json"));
    CHECK(j["stopped"] == "signal");
    for (const char* backend : {"bvh", "grid"}) {
        CHECK(j[backend]["rays"] > 0);
        CHECK(j[backend]["rays"] < 4500000);
        CHECK(j[backend]["class_errors"] == 0);
    }
    REQUIRE(f.etalon("crosscheck ball.p3f -b bvh --rays 20 --json c.json").status == 0);
    CHECK(json::parse(f.read("c.json")).at("stopped").is_null());
}

TEST_CASE("An interrupted etalon-bench speed keeps its measurements", "[app]") {
    const Folder f;
    const auto r = interrupted(f,
                               "etalon-bench speed --scene spheres:20,spheres:30 --backends bvh "
                               "--rays camera --repeat 1000 --oracle 0.02 --json s.json",
                               "grep -q '^build *bvh' out");
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("Stopped by a signal in spheres:20."));
    const json j = json::parse(f.read("s.json"));
    CHECK(j["stopped"] == "signal");
    REQUIRE(j["scenes"].size() == 1);
    CHECK(j["scenes"][0]["build"].contains("bvh"));
    CHECK_FALSE(j["scenes"][0].contains("rays"));
}

TEST_CASE("The results of an etalon-bench that is killed say that they are not all", "[app]") {
    const Folder f;
    for (const std::string command :
         {"speed --scene spheres:20,spheres:300000 --backends bvh --rays camera --repeat 100 "
          "--oracle 0.02",
          "frames spheres:20 spheres:300000 --width 100 --repeat 20",
          "accuracy --case SPH-1 --backends bvh --rays 1e6"}) {
        CAPTURE(command);
        f.shell("rm -f part.json");
        const auto r = interrupted(f, "etalon-bench " + command + " --json part.json",
                                   "test -s part.json", "KILL");
        CHECK(r.status == 137);
        const json j = json::parse(f.read("part.json"));
        CHECK(j["stopped"] == "error");
        CHECK((j.contains("scenes") || !j.value("frames", json()).empty() ||
               !j.value("rows", json()).empty()));
    }
}

TEST_CASE("An interrupted etalon-bench accuracy gives the cases until then", "[app]") {
    const Folder f;
    const auto r = interrupted(f,
                               "etalon-bench accuracy --backends bvh --rays 1e5 --json a.json "
                               "--markdown a.md",
                               "grep -q bvh out");
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("Stopped by a signal"));
    const json j = json::parse(f.read("a.json"));
    CHECK(j["stopped"] == "signal");
    CHECK(j["rows"].size() >= 1);
    CHECK(j["rows"][0]["rays"] == 100000);
    CHECK(f.read("a.md").find("Stopped by a signal") == 0);
    CHECK(f.shell("'" ETALON_BINARY_DIR
                  "/bin/etalon-bench' accuracy --case PLN-1 --rays 1 --json no/such/a.json")
              .status == 4);
}

TEST_CASE("An interrupted etalon-bench report says so on standard error, too", "[app]") {
    const Folder f;
    const auto r = interrupted(f, "etalon-bench report --quick", "test -s report/index.html");
    CHECK(r.status == 130);
    CHECK_THAT(r.err, ContainsSubstring("the report is incomplete: It was interrupted after"));
    CHECK_THAT(f.read("report/index.html"), ContainsSubstring("It was interrupted after"));
}

TEST_CASE("An interrupted etalon-bench frames gives the repeats until then", "[app]") {
    const Folder f;
    constexpr int repeats = 100;
    const auto r = interrupted(f,
                               "etalon-bench frames spheres:20 spheres:300000 --width 100 "
                               "--repeat 100 --json f.json",
                               has_worked(400));
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("Stopped by a signal"));
    const json j = json::parse(f.read("f.json"));
    CHECK(j["stopped"] == "signal");
    REQUIRE_FALSE(j["frames"].empty());
    for (const json& frame : j["frames"]) {
        CHECK(frame["cpu_seconds"]["render"] > 0);
        CHECK(frame["repeats"] >= 1);
        CHECK(frame["repeats"] <= repeats);
        // The last one, too, is complete if the signal came before the first repeat of the next.
        CHECK((frame["repeats"] == repeats || frame == j["frames"].back()));
    }
    const auto none = interrupted(f,
                                  "etalon-bench frames spheres:200000 --width 4000 --repeat 1 "
                                  "--json f.json",
                                  has_worked(100));
    CHECK(none.status == 130);
    CHECK(json::parse(f.read("f.json"))["frames"].empty());
}

TEST_CASE("An interrupted etalon-bench convergence gives the curves until then", "[app]") {
    const Folder f;
    const auto r = interrupted(f,
                               "etalon-bench convergence spheres:200000 --samplers sobol "
                               "--backends bvh,none --seeds 200 --spp 4 --width 16 --json c.json",
                               "grep -qE ' [5-9][0-9] %' err");  // the first of two curves is done
    CHECK(r.status == 130);
    CHECK_THAT(r.out, ContainsSubstring("Stopped by a signal"));
    const json j = json::parse(f.read("c.json"));
    CHECK(j["stopped"] == "signal");
    REQUIRE_FALSE(j["curves"].empty());
    CHECK(j["curves"][0]["backend"] == "bvh");
    CHECK(j["curves"][0]["points"].size() == 3);
    CHECK(j["curves"][0]["seeds"] == 200);
    if (j["curves"].size() > 1) CHECK(j["curves"][1]["seeds"] < 200);
}

TEST_CASE("An interrupted render writes the image rendered so far", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::pair<std::string, int> signals[] = {{"INT", 130}, {"TERM", 143}, {"HUP", 129}};
    for (const auto& [signal, status] : signals) {
        INFO(signal);
        const auto r = interrupted(f, "etalon render ball.p3f --spp 10000000 -o cut.exr",
                                   has_worked(100), signal);
        CHECK(r.status == status);
        CHECK(pixels(f.path("cut.exr")).size() == 32 * 24 * 3);
    }
    // No partial file remains; its name would begin with a dot.
    CHECK(f.shell("rm out err loop; ls -A").out == "ball.p3f\ncut.exr\n");
}

TEST_CASE("Signals that come in a pair are one request", "[app]") {
    const Folder f;
    for (const std::string second : {"INT", "TERM"}) {
        const auto r =
            interrupted(f,
                        "etalon-bench speed --scene spheres:20 --backends bvh --rays "
                        "camera --repeat 1000 --oracle 0.02 --json s.json",
                        "grep -q '^build *bvh' out", "INT $pid; sleep 0.01; kill -" + second);
        CHECK(r.status == 130);
        CHECK(json::parse(f.read("s.json"))["stopped"] == "signal");
        f.shell("rm s.json");
    }
}

TEST_CASE("Signals that wait for the program together count as the first of them", "[app]") {
    // It keeps a signal for later, and loses it if the thread that got it ends before.
    SKIP_UNLESS(!is_thread_sanitized, "a build without the thread sanitizer");
    const Folder f;
    const auto r = interrupted(f,
                               "etalon-bench speed --scene spheres:20 --backends bvh --rays "
                               "camera --repeat 1000 --oracle 0.02 --json s.json",
                               "grep -q '^build *bvh' out",
                               "STOP $pid; kill -INT $pid; kill -TERM $pid; kill -CONT");
    CHECK(r.status == 130);
}

TEST_CASE("A later signal, of any kind, ends the program at once", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("mkfifo pipe");
    for (const auto& [second, status] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
        const auto r = f.shell(
            "sleep 60 <pipe & reader=$!; '" ETALON_BINARY_DIR
            "/bin/etalon' render ball.p3f --resolution 400x300 --spp 10000000 -q -o - >pipe & "
            "pid=$!; until " +
            has_worked(50) +
            "; do sleep 0.02; done; kill -INT $pid; sleep 2; kill -0 $pid && kill -" + second +
            " $pid; wait $pid; status=$?; kill $reader; exit $status");
        CHECK(r.status == status);
    }
}
