// etalon-bench convergence as a process: what it checks, and what it warns of.
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/report/tasks.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

/// A sphere with an image for its colour, which is none.
const char* const textured = R"(LookAt 0 0 5 0 0 0 0 1 0
Camera "perspective" "float fov" 30
Film "image" "integer xresolution" 8 "integer yresolution" 8
WorldBegin
LightSource "point" "rgb I" [10 10 10] "point from" [0 3 5]
Texture "a" "spectrum" "imagemap" "string filename" "x.png"
Material "matte" "texture Kd" "a"
Shape "sphere"
WorldEnd
)";

/// Returns the lines of a text without those of the progress, which a command that takes seconds
/// prints.
std::string without_progress(const std::string& text) {
    std::istringstream lines(text);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(" %, ") == line.npos) kept += line + "\n";
    }
    return kept;
}

/// A folder with that scene.
struct TexturedFolder : Folder {
    TexturedFolder() {
        write("t.pbrt", textured);
        write("x.png", "no image");
    }
    ProgramResult bench(const std::string& arguments) const {
        return shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' " + arguments);
    }
};

}  // namespace

TEST_CASE("convergence: given an integrator that cannot render the scene, then it measures none") {
    const TexturedFolder f;
    const auto r = f.bench("convergence t.pbrt --integrators path,whitted --spp 4 --json c.json");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, ContainsSubstring("--integrators: whitted cannot render a pbrt scene"));
    CHECK(r.out.empty());
    CHECK_FALSE(f.has("c.json"));
}

TEST_CASE("convergence: given no such scene or reference, then the program says so by its name") {
    const TexturedFolder f;
    CHECK_THAT(f.bench("convergence soap").err,
               ContainsSubstring("etalon-bench: error: soap: no such scene"));
    f.write("t.tsv", "image\tcpu_s\nx.png\t1\n");
    const auto r = f.bench("convergence t.pbrt --foreign t.tsv --reference none.exr");
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring("etalon-bench: error: none.exr: cannot be read"));
}

TEST_CASE("convergence: given a kill in a curve, then its files have the curves before it") {
    const TexturedFolder f;
    // The second curve takes a thousand times as long as the first: its backend tests every sphere.
    f.shell("'" ETALON_BINARY_DIR
            "/bin/etalon-bench' convergence spheres:200000 --width 32 --spp 4 --seeds 1 "
            "--samplers sobol --backends bvh,none --json c.json --csv c.csv & "
            "until [ -s c.csv ] || ! kill -0 $!; do sleep 0.01; done; kill -9 $!");
    const nlohmann::json written = nlohmann::json::parse(f.read("c.json"));
    CHECK(written["stopped"] == "error");
    REQUIRE(written["curves"].size() == 1);
    CHECK(written["curves"][0]["backend"] == "bvh");
    CHECK_THAT(f.read("c.csv"), ContainsSubstring("sobol, bvh") && !ContainsSubstring("none"));
}

TEST_CASE("An image that cannot be read is told by convergence and frames, as by render") {
    const TexturedFolder f;
    const std::string warning = f.etalon("render t.pbrt --spp 1 -q -o t.exr").err;
    REQUIRE_THAT(warning, ContainsSubstring("t.pbrt:6:") && ContainsSubstring("x.png") &&
                              ContainsSubstring("stands in"));
    for (const char* command : {"convergence t.pbrt --spp 4 --seeds 2 --samplers sobol",
                                "frames t.pbrt --repeat 2 --backends bvh,grid"}) {
        const auto r = f.bench(command);
        CHECK(r.status == 0);
        CHECK(without_progress(r.err) == warning);
    }
}

TEST_CASE("A report compares no scene with an image that cannot be read") {
    using namespace etalon::bench_report;
    const TexturedFolder f;
    REQUIRE(f.etalon("render t.pbrt --spp 16 -q -o t-16.exr").status == 0);
    f.write("t.tsv", "scene\tcpu_s\trelmse\nt.pbrt\t1\t0.1\n");
    Results results;
    results.settings = quick_settings();
    results.settings.foreign_samples = 4;
    REQUIRE(add_foreign(f.path("t.tsv"), results.settings) == "");
    const std::atomic<bool> stop = false;
    for (const Task& task : foreign_tasks(results.settings)) {
        task.run(results, {stop, etalon::Deadline(), [](double) {}});
    }
    REQUIRE(results.foreign.list.size() == 1);
    CHECK_THAT(results.foreign.list[0].missing, ContainsSubstring("x.png"));
}
