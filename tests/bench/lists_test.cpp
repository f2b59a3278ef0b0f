// Lists of names on the command line: what is named twice is measured once.
#include <nlohmann/json.hpp>

#include "app/common/joined_words.h"
#include "bench/report/settings.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

json measured(const Folder& folder, const std::string& arguments) {
    const auto r = folder.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' " + arguments +
                                " --json j.json");
    INFO(arguments);
    REQUIRE(r.status == 0);
    return json::parse(folder.read("j.json"));
}

}  // namespace

TEST_CASE("A list: given a backend twice, then it is measured once") {
    const Folder f;
    CHECK(measured(
              f, "accuracy --case SPH-4 --rays 10 --only-backends --backends bvh,grid,bvh")["rows"]
              .size() ==
          2 * measured(f, "accuracy --case SPH-4 --rays 10 --only-backends --backends bvh")["rows"]
                  .size());
    CHECK(
        measured(f, "frames spheres:9 spheres:9 --backends bvh,bvh --width 9 --repeat 1")["frames"]
            .size() == 1);
    CHECK(measured(f,
                   "convergence spheres:9 --width 9 --spp 4 --seeds 1 --samplers sobol,sobol "
                   "--backends bvh,bvh --integrators auto,auto")["curves"]
              .size() == 1);
}

TEST_CASE("Backends: given -b, as render has it, then every command measures these") {
    const Folder f;
    const json speed =
        measured(f, "speed --scene spheres:9 --only-build -b grid --repeat 1")["scenes"];
    CHECK(speed[0]["build"].contains("grid"));
    CHECK_FALSE(speed[0]["build"].contains("bvh"));
    const json rows =
        measured(f, "accuracy --case SPH-4 --rays 10 --only-backends -b grid")["rows"];
    for (const json& row : rows) CHECK(row["tracer"] == "grid");
    const std::string small = " spheres:9 --width 9 -b grid";
    CHECK(measured(f, "frames --repeat 1" + small)["frames"][0]["backend"] == "grid");
    CHECK(measured(f, "convergence --spp 4 --seeds 1 --samplers sobol" +
                          small)["curves"][0]["backend"] == "grid");
}

TEST_CASE(
    "A list: given a scene twice, then it is measured once, whatever commas are in its name") {
    const Folder f;
    f.write("a,a,b.p3f", small_scene);
    const json scenes = measured(f,
                                 "speed --scene spheres:9,a,a,b.p3f,spheres:9,a,a,b.p3f "
                                 "--only-build --backends bvh --repeat 1")["scenes"];
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[1]["scene"] == "a,a,b.p3f");
    const auto is_name = [](const std::string& name) { return name == "x, y" || name == "z, y"; };
    CHECK(etalon::joined_words({"x", " y", "z", " y", "x", " y"}, is_name) ==
          std::vector<std::string>{"x, y", "z, y"});
}

TEST_CASE("A report: given a scene that is also in a folder, then its frames are measured once") {
    const Folder f;
    f.write("a.p3f", small_scene);
    etalon::bench_report::Settings settings = etalon::bench_report::quick_settings();
    const std::size_t before = settings.frames.size();
    const std::string folder = f.path("a.p3f").substr(0, f.path("a.p3f").size() - 6);
    REQUIRE(add_frames({f.path("a.p3f"), folder, f.path("a.p3f")}, settings).empty());
    CHECK(settings.frames.size() == before + 1);
}
