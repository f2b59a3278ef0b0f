// Renderings that are interrupted at any moment and resumed from their checkpoints.
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/hash64.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// A rendering that takes a second or less.
const std::vector<std::string> tasks = {
    "glass.p3f --spp 64",
    "soft_shadows.p3f --integrator path --spp 12 --filter gaussian",
    "lights.p3f --integrator ao --target-error 8e-4 --aov variance,albedo,sampleCount",
    "mirrors.p3f --integrator path --target-error 2e-2 --filter mitchell --spp 64",
    "spheres.p3f --spp 40 --sampler random --aov variance",
};

const std::string size = " --resolution 96x72 -t 2 -q ";

std::string arguments(const std::string& task) {
    return " render '" ETALON_SOURCE_DIR "/scenes/features/'" + task + size;
}

std::string render(const std::string& task) {
    return "'" ETALON_BINARY_DIR "/bin/etalon'" + arguments(task);
}

/// Renders without interruption to whole.exr. Returns the time in seconds.
double render_whole(const Folder& f, const std::string& task) {
    REQUIRE(f.shell(render(task) + "-o whole.exr --stats whole.json").status == 0);
    return json::parse(f.read("whole.json"))["seconds"]["total"];
}

/// Resumes without interruption and compares the file with that of an uninterrupted rendering.
void check_resumed(const Folder& f, const std::string& task) {
    const auto r = f.shell(render(task) + "-o image.exr --checkpoint c --resume --stats s.json");
    CAPTURE(task, r.err);
    REQUIRE(r.status == 0);
    CHECK(f.read("image.exr") == f.read("whole.exr"));
    // Not null, as it is of a rendering that began anew; 0 during the first sample of the pixels.
    CHECK(json::parse(f.read("s.json"))["checkpoints"]["resumed_spp"].is_number());
}

const std::string checkpointed = "-o image.exr --checkpoint c --checkpoint-every 0.01 ";

/// Writes a checkpoint of the first sample of each pixel. Returns its content.
std::string render_first_checkpoint(const Folder& f, const std::string& task) {
    REQUIRE(f.shell(render(task) + checkpointed + "--time-limit 1e-9").status == 0);
    REQUIRE(f.has("c"));
    return f.read("c");
}

/// Kills a rendering once it has a checkpoint and then at random moments, resuming it each time;
/// after an end it begins anew. At last resumes it to the end. Returns how often it was killed.
int kill_at_random(const Folder& f, const std::string& task, int kills, std::mt19937& random) {
    std::uniform_real_distribution<double> moment(0.02, 0.05 + render_whole(f, task));
    int killed = 0;
    bool is_new = true;
    for (int i = 0; i < kills; ++i) {
        if (is_new) f.shell("rm -f c image.exr");
        const char* signal = i % 4 == 3 ? "TERM" : "KILL";
        const auto r =
            is_new ? interrupted(f, "etalon" + arguments(task) + checkpointed, "test -s c", "KILL")
                   : f.shell(fmt::format("timeout -s {} {:.3f} ", signal, moment(random)) +
                             render(task) + checkpointed + "--resume");
        const bool known = r.status == 0 || r.status == 124 || r.status == 128 + SIGKILL;
        CAPTURE(r.status, r.err);
        CHECK(known);
        is_new = r.status == 0;
        killed += !is_new;
    }
    check_resumed(f, task);
    return killed;
}

/// Number of calls that may fail in a rendering that ends early and so writes its checkpoint at the
/// end: enough for all of them, including those for the image.
constexpr int calls_hit = 30;

std::string with_fault(const std::string& fault) {
    return "FAULT=" + fault + " LD_PRELOAD='" ETALON_BINARY_DIR "/lib/fault_injection.so' ";
}

}  // namespace

TEST_CASE("A rendering killed at random moments gives the same file once resumed", "[app]") {
    const Folder f;
    std::mt19937 random(1);
    int killed = 0;
    for (const std::string& task : tasks) killed += kill_at_random(f, task, 3, random);
    CHECK(killed > 0);
}

TEST_CASE("Two hundred kills leave the image as it would have been", "[app][long]") {
    const Folder f;
    std::mt19937 random(2);
    int killed = 0;
    for (const std::string& task : tasks) killed += kill_at_random(f, task, 40, random);
    CHECK(killed > 20);
}

TEST_CASE("A kill at any call that writes a checkpoint leaves an old one or a new one",
          "[app][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    const std::string& task = tasks[1];
    render_whole(f, task);
    render_first_checkpoint(f, task);
    int killed = 0;
    for (int call = 1; call <= calls_hit; call += 3) {
        const auto r = f.shell(with_fault(fmt::format("{}:kill ", call)) + render(task) +
                               checkpointed + "--resume");
        killed += r.status == 128 + SIGKILL;
        CHECK((r.status == 128 + SIGKILL || r.status == 0));
        CHECK(f.has("c"));  // if it is damaged, the next run cannot resume it
    }
    CHECK(killed > 3);
    check_resumed(f, task);
}

TEST_CASE("A checkpoint that cannot be written is a warning, and the old one is kept",
          "[app][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    const std::string& task = tasks[0];
    render_whole(f, task);
    const std::string old = render_first_checkpoint(f, task);
    for (const int error : {ENOSPC, EIO}) {
        for (const int call : {1, 2, 7, 20}) {
            f.write("c", old);
            const auto r = f.shell(with_fault(fmt::format("{}+:{} ", call, error)) + render(task) +
                                   checkpointed + "--resume");
            CAPTURE(error, call, r.err);
            if (call <= 4) {  // a file takes four: none can be written
                CHECK(r.status == 4);
                CHECK(f.read("c") == old);
                const std::size_t warning = r.err.find("warning: checkpoint ");
                REQUIRE(warning != r.err.npos);
                CHECK_THAT(r.err, ContainsSubstring("/c: cannot be written"));
                CHECK(r.err.rfind("warning: checkpoint ") == warning);  // the only one
            }
            CHECK((r.status == 4) == (r.err.find("image.exr: cannot be written") != r.err.npos));
            check_resumed(f, task);
        }
        CHECK(f.shell("ls -A | grep -c tmp").out == "0\n");
    }
}

TEST_CASE("Signals that interrupt calls, and writes of a part, leave files as they would have been",
          "[app][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    const std::string& task = tasks[0];
    render_whole(f, task);
    for (const char* fault : {"4:4", "2%:4", "3%:4", "1+:half", "2%:half", "5%:half"}) {
        f.shell("rm -f c image.exr");
        const auto r = f.shell(with_fault(std::string(fault) + " ") + render(task) + checkpointed);
        CAPTURE(fault, r.err);
        CHECK(r.status == 0);
        CHECK(r.err.empty());
        CHECK(f.read("image.exr") == f.read("whole.exr"));
        CHECK(f.shell("ls -A | grep -c tmp").out == "0\n");
        check_resumed(f, task);
    }
    static_assert(EINTR == 4);
}

TEST_CASE("A folder that vanishes during rendering is reported", "[app]") {
    const Folder f;
    f.shell("mkdir there");
    const auto r = interrupted(f,
                               "etalon render '" ETALON_SOURCE_DIR
                               "/scenes/features/glass.p3f' --spp 4000 -q "
                               "-o there/image.exr --checkpoint there/c",
                               "{ " + has_worked(20) + " && rm -r there; }");
    CHECK(r.status == 128 + SIGINT);
    CHECK_THAT(r.err, ContainsSubstring("image.exr: cannot be written: No such file or directory"));
    CHECK(!f.has("there"));
}

TEST_CASE("A checkpoint of another rendering is an error, which names the difference", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("other.p3f", small_scene + "s 0 2 0 0.5\n");
    const std::string options = " --spp 60000 -q -o a.exr --checkpoint c --time-limit 0.3";
    REQUIRE(f.etalon("render ball.p3f" + options).status == 0);
    const std::pair<std::string, std::string> others[] = {
        {"ball.p3f --spp 50000", "spp is 60000, here 50000"},
        {"ball.p3f --spp 60000 --seed 3", "seed is 0, here 3"},
        {"ball.p3f --spp 60000 --integrator ao", "integrator is \"whitted\", here \"ao\""},
        {"ball.p3f --spp 60000 --resolution 64x48 --filter triangle",
         "resolution is [32,24], here [64,48]; "},
        {"ball.p3f --spp 60000 --one-sided", "one-sided is false, here true"},
        {"ball.p3f --spp 60000 -b embree-builtin", "backend is \"exact\", here \"embree-builtin\""},
        {"ball.p3f --spp 60000 --sampler random", "image: sampler is \"sobol\", here \"random\""},
        {"ball.p3f --spp 60000 --max-depth 2", "image: max-depth is 5, here 2"},
        {"ball.p3f --spp 60000 --display-values",
         "image: display values is [true,false], here [true,true]"},
        {"ball.p3f --spp 60000 --target-error 1e-3", "image: target-error is 0.0, here 0.001"},
        {"ball.p3f --spp 60000 --aov variance", "image: variance is false, here true"},
        {"ball.p3f --spp 60000 --crop 0,0,8,8", "image: crop is [0,0,32,24], here [0,0,8,8]"},
        {"ball.p3f --spp 60000 --part 1/2", "image: part is [1,1], here [1,2]"},
        {"ball.p3f --spp 60000 --filter gaussian:3",
         "image: filter is [\"box\",[0.5,0.5]], here [\"gaussian\",[3.0,3.0,2.0]]"},
        {"ball.p3f --spp 60000 --legacy p3f",
         "legacy is \"\", here \"p3f\"; max-depth is 5, here 6; rules of whitted is [false,"},
        {"other.p3f --spp 60000", "of another image: scene is "}};
    for (const auto& [arguments, difference] : others) {
        const auto r = f.etalon("render -q -o b.exr --checkpoint c --resume " + arguments);
        CAPTURE(arguments, r.err);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring(difference));
        CHECK_FALSE(f.has("b.exr"));
    }
    const auto resumed = f.etalon("render ball.p3f -b grid -t 1 --stats s.json --resume" + options);
    CHECK(resumed.status == 0);
    CHECK(json::parse(f.read("s.json"))["checkpoints"]["resumed_spp"] > 0);
}

TEST_CASE("A checkpoint of shorter rays or of another frame is of another image", "[app]") {
    const Folder f;
    const std::string frame =
        "Film \"image\" \"integer xresolution\" 32 \"integer yresolution\" 24\n"
        "WorldBegin\nLightSource \"infinite\"\nShape \"sphere\"\nWorldEnd\n";
    f.write("ball.p3f", small_scene);
    f.write("frames.pbrt", frame + frame);
    struct Row {
        std::string scene, first, second, difference;
    };
    const Row rows[] = {{"ball.p3f --integrator ao", " --max-distance 2", "",
                         "image: max-distance is 2.0, here \"infinite\""},
                        {"frames.pbrt", " --frame 1", " --frame 2", "image: frame is 1, here 2"}};
    for (const auto& [scene, first, second, difference] : rows) {
        const std::string command = "render -q --spp 60000 --checkpoint c " + scene;
        REQUIRE(f.etalon(command + first + " -o a.exr --time-limit 0.3").status == 0);
        const auto r = f.etalon(command + second + " -o b.exr --resume");
        CAPTURE(scene, r.err);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring(difference));
        CHECK_FALSE(f.has("b.exr"));
    }
}

TEST_CASE("A rendering advances in every slice of time", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string slice =
        "render ball.p3f --spp 1000000 -t 1 -q -o a.exr --checkpoint c --resume --stats s.json "
        "--time-limit 0.2";
    double samples = 0;
    for (int i = 0; i < 4; ++i) {
        CAPTURE(i);
        REQUIRE(f.etalon(slice).status == 0);
        const double until_then = samples;
        samples = json::parse(f.read("s.json"))["image"]["spp"];
        CHECK(samples > until_then);
    }
}

TEST_CASE("A damaged checkpoint is refused", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string options =
        "render ball.p3f --spp 60000 -q -o a.exr --checkpoint c --time-limit 0.2";
    REQUIRE(f.etalon(options).status == 0);
    const std::string whole = f.read("c");
    const auto refused = [&](std::string content) {
        f.write("c", content);
        const auto r = f.etalon(options + " --resume");
        CAPTURE(content.size());
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring("etalon: error: c: "));
        CHECK_THAT(r.err, ContainsSubstring("damaged") || ContainsSubstring("another version"));
    };
    for (const std::size_t kept :
         {std::size_t{0}, std::size_t{7}, std::size_t{18}, whole.size() / 2, whole.size() - 1}) {
        refused(whole.substr(0, kept));
    }
    for (const std::size_t at :
         {std::size_t{18}, std::size_t{40}, whole.size() / 3, whole.size() - 3}) {
        std::string damaged = whole;
        damaged[at] ^= 4;
        refused(damaged);
    }
    refused(whole + "x");
}

TEST_CASE("A resumed rendering that ends at once has the error of what it resumes", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --spp 4 -q -o b.exr").status == 0);
    const std::string command =
        "render ball.p3f --spp 100000 -t 1 -o a.exr --checkpoint state --reference b.exr ";
    REQUIRE(f.etalon(command + "--time-limit 2 -q").status == 0);
    const auto r = f.etalon(command + "--time-limit 1e-9 --resume --stats s.json");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring(" from b.exr"));
    CHECK_FALSE(nlohmann::json::parse(f.read("s.json"))["convergence"].empty());
}

TEST_CASE("A checkpoint is no pipe", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("mkfifo pipe");
    const auto r = f.etalon("render ball.p3f -o a.exr --checkpoint pipe --resume");
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring("pipe: is no regular file"));
    CHECK(f.etalon("render ball.p3f -o a.exr --checkpoint -").status == 2);
}

TEST_CASE("The options of checkpoints need one, and to resume none is to begin anew", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK(f.etalon("render ball.p3f -q --resume").status == 2);
    CHECK(f.etalon("render ball.p3f -q --checkpoint-every 3").status == 2);
    CHECK(f.etalon("render ball.p3f -q --checkpoint c --checkpoint-every 0").status == 2);
    const auto anew = f.etalon("render ball.p3f -q -o a.exr --checkpoint c --resume");
    CHECK(anew.status == 0);
    CHECK_THAT(anew.err, ContainsSubstring("c: no such file; rendering begins anew"));
    CHECK_FALSE(f.has("c"));  // it was over before one was due
    const auto nowhere = f.etalon("render ball.p3f -q -o a.exr --checkpoint no/folder/c");
    CHECK(nowhere.status == 0);
    CHECK_THAT(nowhere.err,
               ContainsSubstring("warning: checkpoint no/folder/c: cannot be written"));
}

TEST_CASE("A hash of bytes does not depend on how they are cut, but on each of them", "[app]") {
    std::string text;
    for (int i = 0; i < 100; ++i) text += static_cast<char>(i * 37);
    for (std::size_t first = 0; first <= text.size(); ++first) {
        etalon::Hash64 hash;
        hash.add(text.substr(0, first));
        hash.add({});  // without an address, which memcpy may not be given
        hash.add(text.substr(first));
        CHECK(hash.value() == etalon::hash64(text));
        std::string other = text;
        if (first < text.size()) other[first] ^= 1;
        CHECK((first == text.size()) == (etalon::hash64(other) == etalon::hash64(text)));
        CHECK((first == text.size()) == (etalon::hash64(text.substr(0, first)) == hash.value()));
    }
}
