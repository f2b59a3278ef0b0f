// etalon-bench speed as a process.
#include <nlohmann/json.hpp>

#include "bench/speed/pinned.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

ProgramResult speed(const Folder& folder, const std::string& arguments) {
    return folder.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' speed " + arguments);
}

std::string one_more_than_cores() {
    return std::to_string(etalon::speed::usable_cores() + 1);
}

/// A plane below a lamp, with nothing in between.
const char* const lamp = R"(LookAt 0 4 -6 0 0 0 0 1 0
Camera "perspective" "float fov" 30
Film "image" "integer xresolution" 32 "integer yresolution" 32
WorldBegin
AttributeBegin
AreaLightSource "diffuse" "rgb L" [10 10 10]
Translate 0 30 0
Shape "sphere" "float radius" 0.5
AttributeEnd
Shape "trianglemesh" "point P" [-9 0 -9  9 0 -9  9 0 9 -9 0 9] "integer indices" [0 1 2 0 2 3]
WorldEnd
)";

const std::string quick = "--scene spheres:200 --repeat 1 --max-rays 500 --oracle 0.02 ";

}  // namespace

TEST_CASE("speed gives every figure its ratios and every speed its errors") {
    const Folder f;
    const auto r = speed(f, quick + "--backends bvh,embree-user --json s.json");
    REQUIRE(r.status == 0);
    const json j = json::parse(f.read("s.json"));
    for (const char* key : {"version", "machine", "compiler", "flags", "embree", "repeats"}) {
        CHECK(j.contains(key));
    }
    CHECK(j["machine"]["cores"] > 0);
    CHECK(j["embree"]["version"] != "");
    const json& scene = j["scenes"].at(0);
    CHECK(scene["primitives"] == 200);
    for (const char* who : {"bvh", "embree-user", "embree-builtin", "embree-builtin-robust"}) {
        INFO(who);
        const char* reference = who == std::string("embree-user") ? "bvh" : "embree-user";
        const json& build = scene["build"].at(who);
        CHECK(build["isa"] != "");
        CHECK(build["bytes_per_primitive"] > 0);
        CHECK(build["threads"]["1"]["repeats"]["cpu_seconds"].size() == 1);
        CHECK(build["threads"]["1"]["ratio"] > 0);
        for (const char* kind : {"camera", "bounce", "shadow", "random"}) {
            const json& rays = scene["rays"].at(kind).at(who);
            for (const char* key : {"mrays_per_s", "ratio", "ratio_robust"}) CHECK(rays[key] > 0);
            CHECK(rays["spread"].is_null());  // of one repeat
            CHECK(rays["repeats"]["cpu_seconds"].size() == 1);
            CHECK(rays["errors"]["reference"] == reference);
            CHECK(rays["errors"]["rays"] > 0);
            CHECK(rays["errors"]["oracle"]["rays"] > 0);
        }
    }
    for (const char* baseline : {"camera", "random"}) {
        CHECK(scene["rays"][baseline]["embree-builtin"]["ratio"] == 1);
        CHECK(scene["rays"][baseline]["embree-builtin-robust"]["ratio_robust"] == 1);
    }
}

TEST_CASE("speed finds no error of an exact backend, whichever takes part") {
    const Folder f;
    REQUIRE(speed(f, quick + "--backends none,grid --rays aimed,shadow --json s.json").status == 0);
    const json j = json::parse(f.read("s.json"));
    for (const char* kind : {"aimed", "shadow"}) {
        for (const char* who : {"none", "grid"}) {
            const json& errors = j["scenes"][0]["rays"][kind][who]["errors"];
            for (const char* error : {"hit_or_miss", "primitive", "t_bits"}) {
                CHECK(errors[error] == 0);
            }
            for (const char* error :
                 {"false_hits", "false_misses", "wrong_primitives", "wrong_roots"}) {
                CHECK(errors["oracle"][error] == 0);
                CHECK(errors["disputed"][error] == 0);
            }
        }
    }
}

TEST_CASE("speed: given a lamp, then all shadow rays end before it and the oracle decides them") {
    const Folder f;
    f.write("lamp.pbrt", lamp);
    const std::string rays = "--scene lamp.pbrt --backends bvh --rays shadow --repeat 1 ";
    REQUIRE(speed(f, rays + "--max-rays 500 --oracle 0.1 --json s.json").status == 0);
    const json j = json::parse(f.read("s.json"));
    const json& tracers = j["scenes"][0]["rays"]["shadow"];
    for (const char* tracer : {"bvh", "embree-builtin"}) {
        const json& errors = tracers[tracer]["errors"];
        CHECK(errors["oracle"]["rays"] > 0);
        for (const char* checked : {"oracle", "disputed"}) {
            CHECK(errors[checked]["undecidable"] == 0);
            CHECK(errors[checked]["false_hits"] == 0);
        }
    }
}

TEST_CASE("speed shows a line for each kind of ray, tracer and number of threads") {
    const Folder f;
    const auto r = speed(f, quick + "--backends bvh --rays camera --threads 1");
    REQUIRE(r.status == 0);
    CHECK_THAT(r.out, ContainsSubstring("\ncamera bvh  ") &&
                          ContainsSubstring("\ncamera embree-builtin-robust  ") &&
                          ContainsSubstring("\nmean   bvh "));
    CHECK_THAT(r.out, !ContainsSubstring("\nshadow"));
    CHECK_THAT(r.out, ContainsSubstring("\nrays ") && ContainsSubstring("\nbuild  bvh "));
}

TEST_CASE("speed compares two threads with one", "[needs_two_cores]") {
    SKIP_UNLESS(etalon::speed::usable_cores() >= 2, "a single core");
    const Folder f;
    REQUIRE(speed(f, quick + "--backends bvh --rays camera --threads 2 --json s.json").status == 0);
    const json j = json::parse(f.read("s.json"));
    for (const json& runs : {j["scenes"][0]["rays"]["camera"]["bvh"]["threads"],
                             j["scenes"][0]["build"]["bvh"]["threads"]}) {
        CHECK(runs["1"]["wall_scaling"] == 1);
        CHECK(runs["2"]["cpu_scaling"] > 0);
        CHECK(runs["2"]["wall_scaling"] > 0);
    }
}

TEST_CASE("speed leaves standard output to JSON where that is asked for") {
    const Folder f;
    const auto r = speed(f, quick + "--backends bvh --rays camera --json -");
    CHECK(json::parse(r.out)["scenes"].size() == 1);
    CHECK_THAT(r.err, ContainsSubstring("camera bvh"));
}

TEST_CASE("speed: given a scene without shapes, then it says which rays it lacks, and no NaN") {
    const Folder f;
    f.write("nothing.p3f",
            "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0.01\n"
            "resolution 16 16\n");
    const auto r = speed(f,
                         "--scene nothing.p3f --repeat 1 --max-rays 50 --oracle 0.01 "
                         "--backends bvh --rays camera,shadow --json s.json");
    REQUIRE(r.status == 0);
    CHECK_THAT(r.out, !ContainsSubstring("nan") && ContainsSubstring("no shadow rays") &&
                          !ContainsSubstring("no camera rays"));
    const json scene = json::parse(f.read("s.json"))["scenes"][0];
    CHECK(scene["shape"] == "mixed");
    CHECK(scene["build"]["bvh"]["bytes_per_primitive"].is_number());
}

TEST_CASE("speed: given shapes that Embree's baseline has not, then it says so") {
    const Folder f;
    const std::string run = " --repeat 1 --max-rays 50 --oracle 0.01 --backends bvh --rays camera";
    const std::string note = "embree-builtin has no kernels for these shapes";
    CHECK_THAT(speed(f, "--scene hair:20" + run).out, ContainsSubstring(note));
    CHECK_THAT(speed(f, "--scene spheres:20" + run).out, !ContainsSubstring(note));
}

TEST_CASE("speed: given a scene that cannot be read, then those before it are written") {
    const Folder f;
    f.write("bad.p3f", "nonsense\n");
    const std::string two =
        "--scene spheres:20,bad.p3f --repeat 1 --max-rays 50 --oracle 0.01 "
        "--backends bvh --rays camera --json ";
    REQUIRE(speed(f, two + "s.json").status == 3);
    for (const json& j : {json::parse(f.read("s.json")), json::parse(speed(f, two + "-").out)}) {
        CHECK(j["stopped"] == "error");
        CHECK(j["scenes"].size() == 1);
    }
}

TEST_CASE("speed: given a file whose name has commas, then it is measured, beside others") {
    const Folder f;
    f.write("a,b,c.p3f", small_scene);
    const std::string how = " --repeat 1 --max-rays 20 --oracle 0 --rays camera --backends bvh";
    REQUIRE(speed(f, "--scene spheres:200,a,b,c.p3f,spheres:300 --json s.json" + how).status == 0);
    std::vector<std::string> names;
    const json written = json::parse(f.read("s.json"));
    for (const json& scene : written["scenes"]) names.push_back(scene["scene"]);
    CHECK(names == std::vector<std::string>{"spheres:200", "a,b,c.p3f", "spheres:300"});
    CHECK_THAT(
        speed(f, "--scene spheres:200,a,b,d.p3f").err,
        ContainsSubstring(" a: no such scene") && ContainsSubstring(" d.p3f: no such scene"));
}

TEST_CASE("speed says what is wrong before it measures anything") {
    const Folder f;
    const auto r = speed(f, "--scene spheres:200,soap");
    CHECK(r.status == 3);
    CHECK(r.out == "");
    CHECK_THAT(r.err, ContainsSubstring("soap: no such scene") &&
                          ContainsSubstring("sphereflake[:DEPTH]"));
    CHECK(speed(f, quick + "--json no/such/place.json").status == 4);
    const auto threads = speed(f, quick + "--threads " + one_more_than_cores());
    CHECK(threads.status == 2);
    CHECK_THAT(threads.err, ContainsSubstring("--threads"));
    CHECK(speed(f, quick + "--backends magic").status == 2);
    CHECK_THAT(speed(f, "--list").out, ContainsSubstring("stadium:268000"));
}
