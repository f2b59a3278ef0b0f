// Parts of images, and their merged images.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "core/image/metrics/metrics.h"
#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// Renders a scene of the feature scenes.
void render(const Folder& f, const std::string& arguments, const std::string& output,
            const std::string& resolution = "80x60") {
    const auto r = f.etalon("render '" ETALON_SOURCE_DIR "/scenes/'" + arguments +
                            " --resolution " + resolution + " -q -o " + output);
    CAPTURE(arguments, r.err);
    REQUIRE(r.status == 0);
}

std::vector<std::string> render_parts(const Folder& f, const std::string& arguments, int parts) {
    std::vector<std::string> names;
    for (int i = 1; i <= parts; ++i) {
        names.push_back(fmt::format("part{}.exr", i));
        render(f, fmt::format("{} --part {}/{}", arguments, i, parts), names.back());
    }
    return names;
}

ProgramResult merge(const Folder& f, const std::vector<std::string>& parts, const std::string& to) {
    std::string arguments;
    for (const std::string& part : parts) arguments += part + " ";
    return f.etalon("merge " + arguments + "-o " + to);
}

void merge_well(const Folder& f, const std::vector<std::string>& parts, const std::string& to) {
    const auto r = merge(f, parts, to);
    CHECK(r.err == "");
    REQUIRE(r.status == 0);
}

/// Cases with filters and samplers, sample numbers that cannot be divided evenly, and lights with
/// more samples at their outlines.
const std::vector<std::pair<std::string, int>> shared = {
    {"features/glass.p3f --spp 13", 4},
    {"features/soft_shadows.p3f --spp 16 --sampler random --filter triangle", 5},
    {"features/lights.p3f --integrator path --spp 32 --filter gaussian", 3},
    {"features/spheres.p3f --integrator ao --spp 16", 16},
    {"pbrt/lights.pbrt --spp 16", 2},
};

}  // namespace

TEST_CASE("All parts of an image merge to its bits, in any order and by steps", "[app]") {
    std::mt19937 random(1);
    for (const auto& [arguments, count] : shared) {
        CAPTURE(arguments);
        const Folder f;
        render(f, arguments, "whole.exr");
        std::vector<std::string> parts = render_parts(f, arguments, count);
        merge_well(f, parts, "merged.exr");
        CHECK(pixels(f.path("merged.exr")) == pixels(f.path("whole.exr")));
        std::shuffle(parts.begin(), parts.end(), random);
        merge_well(f, parts, "shuffled.exr");
        CHECK(f.read("shuffled.exr") == f.read("merged.exr"));
        const std::string last = parts.back();
        parts.pop_back();
        merge_well(f, parts, "but_one.exr");
        merge_well(f, {last, "but_one.exr"}, "by_steps.exr");
        CHECK(pixels(f.path("by_steps.exr")) == pixels(f.path("whole.exr")));
        CHECK(pixels(f.path("but_one.exr")) != pixels(f.path("whole.exr")));
    }
}

TEST_CASE("A part is an image with more noise, sampled in the same way", "[app]") {
    const Folder f;
    const std::string scene = "features/soft_shadows.p3f ";
    render(f, scene + "--spp 1024", "reference.exr");
    const auto error = [&](const std::string& name) {
        REQUIRE(f.etalon("compare " + name + " reference.exr --json c.json").status == 0);
        return json::parse(f.read("c.json"))["relmse"].get<double>();
    };
    const auto parts = render_parts(f, scene + "--spp 64", 4);
    render(f, scene + "--spp 16", "as_many.exr");
    render(f, scene + "--spp 64", "whole.exr");
    for (const std::string& part : parts) {
        CAPTURE(part);
        CHECK(error(part) <
              1.3 * error("as_many.exr"));  // as well distributed as its first samples
        CHECK(error(part) > 1.5 * error("whole.exr"));
    }
}

TEST_CASE("Crops and other seeds merge, weighted by their samples", "[app]") {
    const Folder f;
    const std::string scene = "features/glass.p3f ";
    for (const std::string filter : {"", "--filter mitchell "}) {
        const std::string options = scene + filter + "--spp 8 ";
        render(f, options, "whole.exr");
        render(f, options + "--crop 0,0,33,60 --part 1/1", "left.exr");
        render(f, options + "--crop 33,0,80,20 --part 1/1", "upper.exr");
        render(f, options + "--crop 33,20,80,60 --part 1/2", "lower1.exr");
        render(f, options + "--crop 33,20,80,60 --part 2/2", "lower2.exr");
        merge_well(f, {"lower2.exr", "upper.exr", "lower1.exr", "left.exr"}, "merged.exr");
        CHECK(pixels(f.path("merged.exr")) == pixels(f.path("whole.exr")));
        const auto r = merge(f, {"upper.exr", "left.exr"}, "hole.exr");
        CHECK(r.status == 0);
        CHECK_THAT(r.err, ContainsSubstring("1880 pixels between the parts are in none"));
    }
    const std::string other = scene + "--display-values ";
    render(f, other + "--spp 8 --seed 1 --part 1/1", "a.exr");
    render(f, other + "--spp 24 --seed 2 --part 1/1", "b.exr");
    merge_well(f, {"a.exr", "b.exr"}, "ab.exr");
    merge_well(f, {"b.exr", "a.exr"}, "ba.exr");
    CHECK(f.read("ab.exr") == f.read("ba.exr"));
    const auto a = pixels(f.path("a.exr")), b = pixels(f.path("b.exr")),
               ab = pixels(f.path("ab.exr"));
    for (std::size_t i = 0; i < ab.size(); ++i) {
        CHECK(std::abs(ab[i] - (8 * a[i] + 24 * b[i]) / 32) < 1e-6);
    }
}

TEST_CASE("A part that was killed and resumed is the same part", "[app]") {
    const Folder f;
    const std::string scene = "features/glass.p3f --spp 2048 --part 2/3 ";
    render(f, scene, "part.exr");
    const auto killed =
        interrupted(f,
                    "etalon render '" ETALON_SOURCE_DIR "/scenes/'" + scene +
                        "--resolution 80x60 -q -o again.exr --checkpoint c --checkpoint-every 0.01",
                    "test -s c", "KILL");
    REQUIRE(killed.status == 128 + SIGKILL);
    render(f, scene + "--checkpoint c --resume --stats s.json", "again.exr");
    // Not null, as it is of a rendering that began anew; 0 during the first sample of the pixels.
    CHECK(json::parse(f.read("s.json"))["checkpoints"]["resumed_spp"].is_number());
    CHECK(f.read("again.exr") == f.read("part.exr"));
}

TEST_CASE("Files that are not parts of one image are an error", "[app]") {
    const Folder f;
    const std::string scene = "features/glass.p3f --spp 8 ";
    render(f, scene, "plain.exr");
    render(f, scene + "--part 1/2", "a.exr");
    render(f, scene + "--part 2/3", "overlap.exr");
    render(f, scene + "--part 2/2 --crop 0,0,40,40", "crop.exr");
    render(f, scene + "--part 2/2", "small.exr", "40x30");
    render(f, scene + "--part 2/2 --filter triangle", "filter.exr");
    render(f, scene + "--part 2/2 --sampler random", "sampler.exr");
    render(f, scene + "--part 2/2 --max-depth 2", "depth.exr");
    render(f, scene + "--part 2/2 --display-values", "values.exr");
    render(f, scene + "--part 2/2 --one-sided", "one_sided.exr");
    render(f, scene + "--part 2/2 --legacy p3f", "legacy.exr");
    render(f, scene + "--part 2/2 -b embree-builtin", "backend.exr");
    render(f, "features/spheres.p3f --spp 8 --part 2/2", "scene.exr");
    render(f, "features/glass.p3f --spp 6 --part 6/6", "few.exr");
    f.write("damaged.exr", [&] {
        std::string text = f.read("a.exr");
        text[text.size() - 300] ^= 1;
        return text;
    }());
    const std::pair<const char*, const char*> wrong[] = {
        {"a.exr", "a.exr and a.exr hold the same samples: numbers 0 to 3 of seed 0"},
        {"overlap.exr", "overlap.exr hold the same samples: numbers 2 to 3 of seed 0"},
        {"crop.exr", "overlap without being the same window"},
        {"small.exr", "not of the same image as a.exr: resolution is [40,30], there [80,60]"},
        {"filter.exr", "filter is [\"triangle\""},
        {"sampler.exr", "as a.exr: sampler is \"random\", there \"sobol\""},
        {"depth.exr", "as a.exr: max-depth is 2, there 5"},
        {"values.exr", "as a.exr: display values is [true,true], there [true,false]"},
        {"one_sided.exr", "as a.exr: one-sided is true, there false"},
        {"legacy.exr", "legacy is \"p3f\", there \"\"; max-depth is 6, there 5; rules of"},
        {"backend.exr", "as a.exr: backend is \"embree-builtin\", there \"exact\""},
        {"scene.exr", "scene is \""},
        {"few.exr", "few.exr may hold the same samples of seed 0"},
        {"plain.exr", "plain.exr: holds no sums of samples; expected an EXR of `etalon render"},
        {"damaged.exr", "damaged.exr: the sums behind the image are damaged"},
        {"none.exr", "none.exr: cannot be read: No such file"}};
    for (const auto& [other, words] : wrong) {
        const auto r = merge(f, {"a.exr", other}, "merged.exr");
        CAPTURE(other, r.err);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring(words));
        CHECK_FALSE(f.has("merged.exr"));
    }
    CHECK(merge(f, {"a.exr"}, "no/such/folder/m.exr").status == 4);
    CHECK(merge(f, {"a.exr"}, "/dev/full/m.exr").status == 4);
    CHECK(merge(f, {"a.exr"}, "m.png").status == 2);
}

TEST_CASE("Parts of images with few and many samples merge by steps as they do at once", "[app]") {
    const Folder f;
    const auto part = [&](int spp, int seed, const char* share, const std::string& output) {
        render(f, fmt::format("features/glass.p3f --spp {} --seed {} --part {}", spp, seed, share),
               output, "24x16");
    };
    part(4, 0, "1/1", "few.exr");
    part(16, 1, "1/2", "first.exr");
    part(16, 1, "2/2", "second.exr");
    merge_well(f, {"few.exr", "first.exr", "second.exr"}, "at_once.exr");
    merge_well(f, {"few.exr", "first.exr"}, "step.exr");
    merge_well(f, {"step.exr", "second.exr"}, "by_steps.exr");
    CHECK(pixels(f.path("by_steps.exr")) == pixels(f.path("at_once.exr")));

    // Numbers 3 to 6 of seed 1, and 0 to 1, which are up to 0 to 31 where pixels have rates.
    part(7, 1, "2/2", "other_few.exr");
    part(16, 1, "1/8", "eighth.exr");
    part(16, 0, "1/2", "other_seed.exr");
    const auto at_once = merge(f, {"other_few.exr", "eighth.exr"}, "m.exr");
    CHECK(at_once.status == 3);
    merge_well(f, {"other_seed.exr", "other_few.exr"}, "step.exr");
    const auto by_steps = merge(f, {"step.exr", "eighth.exr"}, "m.exr");
    CHECK(by_steps.status == 3);
    CHECK_THAT(by_steps.err, ContainsSubstring("may hold the same samples of seed 1"));
}

TEST_CASE("A part of a scene that is too large for a matrix of floats merges", "[app]") {
    const Folder f;
    f.write("far.p3f",
            "camera eye 1e39 1e39 5e39 at 0 0 0 up 0 1 0 angle 45 hither 0 resolution 16 12 "
            "aperture 0 focal 1\nlight punctual 3e39 5e39 4e39 1 1 1\n"
            "mat 0.8 0.6 0.4 0.9 1 1 1 0 10 0 1\ns 0 0 0 1e39\n");
    REQUIRE(f.etalon("render far.p3f --spp 2 -q --part 1/1 -o far.exr").status == 0);
    merge_well(f, {"far.exr"}, "merged.exr");
    CHECK(pixels(f.path("merged.exr")) == pixels(f.path("far.exr")));
}

TEST_CASE("merge neither replaces a part nor waits for a pipe", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --spp 2 -q --part 1/2 -o a.exr").status == 0);
    REQUIRE(f.etalon("render ball.p3f --spp 2 -q --part 2/2 -o b.exr").status == 0);
    const std::string before = f.read("a.exr");
    const auto replacing = merge(f, {"b.exr", "a.exr"}, "a.exr");
    CHECK(replacing.status == 2);
    CHECK_THAT(replacing.err, ContainsSubstring("a.exr: is an input, which would be lost"));
    CHECK(f.read("a.exr") == before);
    REQUIRE(f.shell("mkfifo pipe.exr").status == 0);
    const auto waiting = merge(f, {"pipe.exr", "a.exr"}, "m.exr");
    CHECK(waiting.status == 3);
    CHECK_THAT(waiting.err, ContainsSubstring("pipe.exr: cannot be read: is no regular file"));
}

TEST_CASE("A merge that a signal ends while it writes leaves nothing behind", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string render = "render ball.p3f --resolution 1920x1080 --spp 2 -q --part ";
    REQUIRE(f.etalon(render + "1/2 -o a.exr").status == 0);
    REQUIRE(f.etalon(render + "2/2 -o b.exr").status == 0);
    // The shell looks for the temporary file without starting programs, so that it is in time.
    const auto r = f.shell(
        "'" ETALON_BINARY_DIR
        "/bin/etalon' merge a.exr b.exr -o m.exr & pid=$!; until set -- .etalon-*; test -e \"$1\" "
        "|| ! kill -0 $pid; do :; done; kill -TERM $pid; wait $pid");
    INFO(r.err);
    CHECK(r.status == 143);
    CHECK(f.shell("ls -A").out == "a.exr\nb.exr\nball.p3f\n");
}

TEST_CASE("A merged image of parts that were stopped says so", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string command = "render ball.p3f --spp 1000000 -q -t 1 --part ";
    REQUIRE(f.etalon(command + "1/2 --time-limit 0.2 -o a.exr").status == 0);
    REQUIRE(f.etalon(command + "2/2 --time-limit 0.2 -o b.exr").status == 0);
    const auto r = merge(f, {"a.exr", "b.exr"}, "m.exr");
    CHECK(r.status == 0);
    for (const char* part : {"a.exr", "b.exr"}) {
        CHECK_THAT(r.err, ContainsSubstring(std::string(part) + ": warning: its rendering was "
                                                                "stopped (time-limit)"));
    }
    CHECK_THAT(f.read("m.exr"), ContainsSubstring("time-limit"));
}

TEST_CASE("Files that have changed places are another scene", "[app]") {
    const Folder f;
    const auto ball = [](const std::string& texture, int place) {
        return "Texture \"" + texture + "\" \"spectrum\" \"imagemap\" \"string filename\" \"" +
               texture + ".png\" Material \"matte\" \"texture Kd\" \"" + texture + "\" Translate " +
               std::to_string(place) + " 0 0 Shape \"sphere\"\n";
    };
    f.write("s.pbrt",
            "LookAt 0 0 9 0 0 0 0 1 0 Camera \"perspective\" Film \"image\" \"integer "
            "xresolution\" 8 \"integer yresolution\" 8 WorldBegin LightSource "
            "\"infinite\"\n" +
                ball("a", -1) + ball("b", 2) + "WorldEnd\n");
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q -o a.png --resolution 4x4").status == 0);
    REQUIRE(f.etalon("render ball.p3f -q -o b.png --resolution 8x8").status == 0);
    const std::string command = "render s.pbrt -q --spp 4 ";
    REQUIRE(f.etalon(command + "--part 1/2 -o 1.exr").status == 0);
    f.shell("mkdir there; cp a.png b.png there; cp s.pbrt there/t.pbrt");
    REQUIRE(f.etalon("render there/t.pbrt -q --spp 4 --part 2/2 -o 2.exr").status == 0);
    merge_well(f, {"1.exr", "2.exr"}, "m.exr");
    f.shell("mv a.png c.png; mv b.png a.png; mv c.png b.png");
    REQUIRE(f.etalon(command + "--part 2/2 -o 2.exr").status == 0);
    const auto r = merge(f, {"1.exr", "2.exr"}, "m.exr");
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring("is not of the same image as 1.exr: scene is"));
}

TEST_CASE("Files of one name that have changed folders are another scene", "[app]") {
    const Folder f;
    f.shell("mkdir -p here/a here/b");
    std::string scene =
        "LookAt 0 0 9 0 0 0 0 1 0 Camera \"perspective\" Film \"image\" \"integer xresolution\" 8 "
        "\"integer yresolution\" 8 WorldBegin LightSource \"infinite\"\n";
    for (const std::string name : {"a", "b"}) {
        scene += "Texture \"" + name + "\" \"spectrum\" \"imagemap\" \"string filename\" \"" +
                 name + "/t.png\" Material \"matte\" \"texture Kd\" \"" + name +
                 "\" Shape \"sphere\"\n";
    }
    f.write("here/s.pbrt", scene + "WorldEnd\n");
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q -o here/a/t.png --resolution 4x4").status == 0);
    REQUIRE(f.etalon("render ball.p3f -q -o here/b/t.png --resolution 8x8").status == 0);
    const std::string end = "here/s.pbrt -q --spp 4 --part ";
    REQUIRE(f.etalon("render " + end + "1/2 -o 1.exr").status == 0);
    REQUIRE(f.etalon("render $PWD/" + end + "2/2 -o 2.exr").status == 0);
    merge_well(f, {"1.exr", "2.exr"}, "m.exr");
    f.shell("cd here; mv a c; mv b a; mv c b");
    REQUIRE(f.etalon("render " + end + "2/2 -o 2.exr").status == 0);
    CHECK(merge(f, {"1.exr", "2.exr"}, "m.exr").status == 3);
}

TEST_CASE("--part needs a valid share, and an image whose samples are known before", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::pair<const char*, const char*> wrong[] = {
        {"--spp 4 --part 0/4", "expected I/N"},
        {"--spp 4 --part 5/4", "expected I/N"},
        {"--spp 4 --part 1", "expected I/N"},
        {"--spp 4 --part 1/2x", "expected I/N"},
        {"--spp 4 --part 1/5", "expected --spp 5"},
        {"--part 1/1", "expected --spp 1"},
        {"--spp 4 --part 1/2 --target-error 0.1", "--part"},
        {"--spp 4 --part 1/2 --aov N", "--part"},
        {"--spp 4 --part 1/2 -o a.png", "no output is an EXR"},
        {"--spd --part 1/2", "--part"}};
    for (const auto& [options, words] : wrong) {
        const auto r = f.etalon(std::string("render ball.p3f -q ") + options);
        CAPTURE(options, r.err);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring(words));
    }
}

TEST_CASE("Sixteen parts of a large image take the memory of three films", "[app][long]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    std::vector<std::string> parts;
    for (int i = 1; i <= 16; ++i) {
        parts.push_back(fmt::format("p{}.exr", i));
        REQUIRE(f.etalon(fmt::format("render ball.p3f --spp 16 --resolution 3840x2160 -q -o {} "
                                     "--part {}/16",
                                     parts.back(), i))
                    .status == 0);
    }
    const auto r = merge(f, parts, "m.exr");
    CHECK(r.status == 0);
    constexpr std::size_t film = std::size_t{3840} * 2160 * (2 * 24 + 4);  // with exact sums
    CHECK(r.peak_bytes < 3 * film);
    REQUIRE(f.etalon("render ball.p3f --spp 16 --resolution 3840x2160 -q -o w.exr").status == 0);
    CHECK(pixels(f.path("m.exr")) == pixels(f.path("w.exr")));
}
