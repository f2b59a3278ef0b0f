#include <nlohmann/json.hpp>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

std::vector<float> pixels(const std::string& path) {
    const auto image = etalon::read_image(path);
    REQUIRE(image.error == "");
    return std::get<std::vector<float>>(image.value.pixels);
}

/// Waits until the process $pid has used a second of processor time: in the middle of its work,
/// however long it has waited for a processor.
const std::string until_it_has_worked =
    "while kill -0 $pid && test $(cut -d ' ' -f 14 /proc/$pid/stat) -lt $(getconf CLK_TCK); do "
    "sleep 0.05; done; ";

}  // namespace

TEST_CASE("render writes SCENE's name with .exr beside the caller by default", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("render ball.p3f -q");
    CHECK(r.status == 0);
    CHECK(r.err == "");
    CHECK(pixels(f.path("ball.exr")).size() == 32 * 24 * 3);
}

TEST_CASE("render gives identical pixels with every exact backend and thread count", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --spp 3 -b none -t 1 -o a.exr").status == 0);
    for (const std::string backend : {"grid", "bvh", "embree", "embree-user"}) {
        REQUIRE(f.etalon("render ball.p3f --spp 3 -o b.exr -t 2 -b " + backend).status == 0);
        CHECK(pixels(f.path("a.exr")) == pixels(f.path("b.exr")));
    }
    REQUIRE(f.etalon("render ball.p3f --spp 3 -o b.exr -b embree-builtin").status == 0);
}

TEST_CASE("render --spd shoots a ray through each pixel corner", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("render ball.p3f --spd -q -o a.exr --stats s.json");
    CHECK(r.status == 0);
    CHECK(pixels(f.path("a.exr")).size() == 32 * 24 * 3);
    CHECK(json::parse(f.read("s.json"))["rays"]["camera"] == 33 * 25);
    CHECK(f.etalon("render ball.p3f --spd --spp 2").status == 2);
}

TEST_CASE("only a format that has one is rendered as its old program did", "[app]") {
    const Folder f;
    f.write("a.nff", "v from 0 0 1 at 0 0 0 up 0 1 0 angle 9 hither 0 resolution 4 4\nl 0 0 1\n");
    f.write("a.prt", "from 0 0 1\nat 0 0 0\nup 0 1 0\nangle 9\nresolution 4 4\nlight 0 0 1\n");
    CHECK(f.etalon("info a.nff").status == 0);
    CHECK(f.etalon("info a.nff --legacy nff").status == 2);
    CHECK(f.etalon("info a.prt --legacy prt").status == 0);
    f.write("a.sce", "sce1.0\neyepos 0 0 5\nball 1 0 0 0\n");
    CHECK(f.etalon("info a.sce --legacy sce").status == 0);
    CHECK(f.etalon("info a.nff --legacy prt").status == 2);
}

TEST_CASE("render takes size, crop, depth, seed and several outputs", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon(
        "render ball.p3f --resolution 64x48 --crop 8,8,24,20 --max-depth 2 "
        "--seed 7 --spp 2 --exposure 1 -o a.exr -o a.png --stats s.json");
    CHECK(r.status == 0);
    CHECK(pixels(f.path("a.exr")).size() == 16 * 12 * 3);
    CHECK(f.has("a.png"));
    const json s = json::parse(f.read("s.json"));
    CHECK(s["format"] == "p3f");
    CHECK(s["backend"] == "bvh");
    CHECK(s["integrator"] == "whitted");
    CHECK(s["image"] == json{{"width", 64}, {"height", 48}, {"spp", 2}, {"seed", 7}});
    CHECK(s["primitives"] == json{{"sphere", 1}, {"plane", 1}});
    CHECK(s["rays"]["camera"] == 16 * 12 * 2);
    for (const char* key : {"parse", "build", "render", "write", "total"}) {
        CHECK(s["seconds"].contains(key));
    }
    CHECK(s["memory_bytes"]["peak_rss"].get<double>() > 0);
}

TEST_CASE("--filter says how samples make pixels; a box of half a pixel is the usual one",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& options) {
        REQUIRE(f.etalon("render ball.p3f --spp 4 -q -o a.exr " + options).status == 0);
        return pixels(f.path("a.exr"));
    };
    const auto plain = render("");
    CHECK(render("--filter box") == plain);
    CHECK(render("--filter box:0.5") == plain);
    const auto gaussian = render("--filter gaussian");
    CHECK(gaussian != plain);
    CHECK(gaussian.size() == plain.size());
    CHECK(render("--filter gaussian:2") == gaussian);
    CHECK(render("--filter gaussian:1.5") != gaussian);
    for (const char* wrong : {"gauss", "box:", "box:0", "box:-1", "box:1x", "box:65", "sinc:nan"}) {
        INFO(wrong);
        const auto r = f.etalon(std::string("render ball.p3f --filter ") + wrong);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring(std::string(wrong) + ": expected"));
    }
    CHECK_THAT(f.etalon("render ball.p3f --filter gausian").err,
               ContainsSubstring("did you mean 'gaussian'?"));
    CHECK(f.etalon("render ball.p3f --spd --filter gaussian").status == 2);
}

TEST_CASE("a seed has 64 bits, all of which count", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& seed) {
        REQUIRE(
            f.etalon("render ball.p3f --spp 1 -q -o a.exr --stats s.json --seed " + seed).status ==
            0);
        CHECK(json::parse(f.read("s.json"))["image"]["seed"].dump() == seed);
        return pixels(f.path("a.exr"));
    };
    const auto first = render("0");
    CHECK(first != render("4294967296"));
    CHECK(render("4294967296") != render("8589934592"));
    CHECK(render("18446744073709551615") != render("4294967295"));
    CHECK(f.etalon("render ball.p3f --seed 18446744073709551616").status == 2);
    CHECK(f.etalon("render ball.p3f --seed -1").status == 2);
}

TEST_CASE("render takes any integrator by name, auto is the scene's own", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& options, const std::string& name) {
        REQUIRE(f.etalon("render ball.p3f --spp 4 -q -o " + name + ".exr --stats " + name +
                         ".json " + options)
                    .status == 0);
        return json::parse(f.read(name + ".json"));
    };
    CHECK(render("", "none")["integrator"] == "whitted");
    CHECK(render("--integrator auto", "auto")["integrator"] == "whitted");
    CHECK(render("--integrator whitted", "whitted")["integrator"] == "whitted");
    const json ao = render("--integrator ao", "ao");
    CHECK(ao["integrator"] == "ao");
    CHECK(ao["rays"]["shadow"] == ao["rays"]["camera_hits"]);
    CHECK(ao["rays"]["reflected"] == 0);
    CHECK(pixels(f.path("auto.exr")) == pixels(f.path("none.exr")));
    CHECK(pixels(f.path("whitted.exr")) == pixels(f.path("none.exr")));
    CHECK(pixels(f.path("ao.exr")) != pixels(f.path("none.exr")));
    const json near = render("--integrator ao --max-distance 0.01", "near");
    CHECK(near["rays"]["shadow_blocked"] < ao["rays"]["shadow_blocked"]);
}

TEST_CASE("an unknown integrator is refused with the list, and what one would ignore", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto unknown = f.etalon("render ball.p3f --integrator bdpt");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("one of auto, whitted, path,"));
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("volpath, ao"));
    f.write("ball.pbrt", "WorldBegin Shape \"sphere\" WorldEnd");
    const auto other = f.etalon("render ball.pbrt --integrator whitted");
    CHECK(other.status == 2);
    CHECK_THAT(other.err, ContainsSubstring("cannot render a pbrt scene; expected"));
    CHECK_THAT(other.err, ContainsSubstring("path or volpath or ao"));
    const std::pair<std::string, std::string> ignored[] = {
        {"--max-distance 2", "--integrator ao"},
        {"--integrator whitted --max-distance 2", "--integrator ao"},
        {"--integrator ao --max-depth 2", "--integrator whitted"},
        {"--integrator ao --spd", "--integrator whitted"}};
    for (const auto& [options, expected] : ignored) {
        INFO(options);
        const auto r = f.etalon("render ball.p3f " + options);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring(expected));
    }
    CHECK(f.etalon("render ball.p3f --integrator ao --max-distance 0").status == 2);
    CHECK(f.etalon("render ball.p3f --integrator ao --max-distance -1").status == 2);
}

TEST_CASE("The scene may come from standard input", "[app]") {
    const Folder f;
    CHECK(f.etalon("render - --format p3f -o a.exr -q", small_scene).status == 0);
    CHECK(f.has("a.exr"));
    CHECK(f.etalon("render - -q", small_scene).status == 0);
    CHECK(f.has("render.exr"));
    CHECK(f.etalon("info -", "x").status == 3);
    CHECK(f.etalon("info -", "sce1.0\neyepos 0 0 5\nball 1 0 0 0\n").status == 0);
}

TEST_CASE("Wrong usage ends with 2, an unusable scene with 3, an unwritable output with 4",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const char* wrong :
         {"", "paint ball.p3f", "render", "render ball.p3f --spp many", "render ball.p3f -b magic",
          "render ball.p3f --crop 1,2,3", "render ball.p3f --crop 0,0,99,5",
          "render ball.p3f --resolution 0x5", "render ball.p3f -o a.gif",
          "render ball.p3f --integrator bdpt", "render ball.p3f --aov M", "trace ball.p3f"}) {
        INFO(wrong);
        const auto r = f.etalon(wrong);
        CHECK(r.status == 2);
        CHECK(r.err + r.out != "");
    }
    f.write("empty.p3f", "");
    for (const char* unusable : {"missing.p3f", "empty.p3f", "."}) {
        INFO(unusable);
        const auto r = f.etalon(std::string("render ") + unusable);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring("error:"));
    }
    for (const char* unwritable : {"-o no/such/place.exr", "-o a.exr --stats no/such/place.json"}) {
        const auto r = f.etalon(std::string("render ball.p3f ") + unwritable);
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring("no/such is not a directory"));
    }
    CHECK(!f.has("a.exr"));  // known before rendering
}

TEST_CASE("Diagnostics name file, line and column", "[app]") {
    const Folder f;
    f.write("odd.p3f", small_scene + "sphere 1 2 3 4\n");
    const auto r = f.etalon("render odd.p3f -q");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("odd.p3f:18:1: warning:"));
    CHECK(f.etalon("render odd.p3f -q --strict").status == 3);
}

TEST_CASE("info tells what a scene holds, as text and as JSON", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK_THAT(f.etalon("info ball.p3f").out,
               ContainsSubstring("1 sphere") && ContainsSubstring("32 x 24"));
    const json j = json::parse(f.etalon("info ball.p3f --json").out);
    CHECK(j["primitives"] == json{{"sphere", 1}, {"plane", 1}});
    CHECK(j["needs"] == json{"mirrored rays"});
}

TEST_CASE("info tells what the images of textures take, by their headers", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --resolution 32x32 -q -o square.png -o float.exr").status ==
            0);
    REQUIRE(f.etalon("render ball.p3f --resolution 30x20 -q -o odd.png").status == 0);
    const auto bytes = [&](const std::string& file) {
        f.write("textured.pbrt",
                "WorldBegin Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + file +
                    "\" Material \"matte\" \"texture Kd\" \"t\" Shape \"sphere\" WorldEnd");
        return json::parse(f.etalon("info textured.pbrt --json").out)["texture_memory_bytes"];
    };
    CHECK(bytes("square.png") == 32 * 32 * 3);
    CHECK(bytes("odd.png") == 32 * 32 * 4);
    CHECK(bytes("float.exr") == 32 * 32 * 12);
    CHECK(json::parse(f.etalon("info ball.p3f --json").out)["texture_memory_bytes"] == 0);
}

TEST_CASE("--resolution keeps the part of the image that a scene crops", "[app]") {
    const Folder f;
    f.write("crop.pbrt",
            "Film \"image\" \"integer xresolution\" 1000 \"integer yresolution\" 800 \"float "
            "cropwindow\" [.3 .7 .5 .75]\nWorldBegin WorldEnd");
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o whole.exr").status == 0);
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o small.exr --resolution 50x40").status == 0);
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o tiny.exr --resolution 1x1").status == 0);
    const auto whole = etalon::read_image(f.path("whole.exr")).value;
    CHECK(whole.width == 400);
    CHECK(whole.height == 200);
    const auto small = etalon::read_image(f.path("small.exr")).value;
    CHECK(small.width == 20);
    CHECK(small.height == 10);
    CHECK(small.origin == Imath::V2i(15, 20));
    CHECK(small.frame == Imath::V2i(50, 40));
    CHECK(etalon::read_image(f.path("tiny.exr")).value.width == 1);
}

TEST_CASE("trace answers ray by ray", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("rays.txt",
            "# a comment\n"
            "0 0 5 0 0 -1\n"
            "0 0 5 0 0 -0x1p1 # twice as fast\n"
            "0 0 5 0 0 -1 0 3.9999999999999996\n"
            "0 0 5 0 0 -1 0 4\n"
            "\n"
            "0 9 0 0 1 0\n"
            "5 5 0 0 -1 0\n");
    for (const char* backend : {"none", "grid", "bvh", "embree", "embree-user"}) {
        const auto r = f.etalon(std::string("trace ball.p3f --rays rays.txt -b ") + backend);
        CHECK(r.status == 0);
        CHECK(r.out ==
              "hit 4 sphere 1 0 0 1\n"
              "hit 2 sphere 1 0 0 1\n"
              "miss\n"
              "hit 4 sphere 1 0 0 1\n"
              "miss\n"
              "hit 6 plane 0 0 -1 0\n");
    }
}

TEST_CASE("trace says where a file of rays is wrong", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::pair<const char*, const char*> wrong[] = {
        {"0 0 5 0 0\n", ":1:1: error: wrong count of numbers; expected 'ox oy oz"},
        {"\n0 0 5  0 1x 1\n", ":2:10: error: not a number; expected 'ox oy oz"},
        {"# rays\n\n 0 0 5 # no more\n", ":3:2: error: wrong count of numbers"},
        {"0 0 5 0 0 1 0 1 1\n", ":1:17: error: time outside of [0, 1)"}};
    for (const auto& [rays, error] : wrong) {
        f.write("bad.txt", rays);
        const auto r = f.etalon("trace ball.p3f --rays bad.txt");
        CHECK(r.status == 3);
        CHECK(r.out == "");
        CHECK_THAT(r.err, ContainsSubstring(std::string("bad.txt") + error));
    }
    CHECK(f.etalon("trace ball.p3f --rays bad.txt -o no/such/hits.txt").status == 4);
}

TEST_CASE("An interrupted render writes what there is", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::pair<std::string, int> signals[] = {{"INT", 130}, {"TERM", 143}, {"HUP", 129}};
    for (const auto& [signal, status] : signals) {
        INFO(signal);
        const auto r = f.shell("rm -f cut.exr; " + std::string(ETALON_BINARY_DIR) +
                               "/bin/etalon render ball.p3f --spp 10000000 -o cut.exr & pid=$!; " +
                               until_it_has_worked + "kill -" + signal + " $pid; wait $pid");
        CHECK(r.status == status);
        CHECK(pixels(f.path("cut.exr")).size() == 32 * 24 * 3);
    }
    CHECK(f.shell("ls").out == "ball.p3f\ncut.exr\n");  // nothing half-written stays
}

TEST_CASE("trace, info and crosscheck know instances", "[app]") {
    const Folder f;
    f.write("i.pbrt",
            "LookAt 0 0 -9  0 0 0  0 1 0 Camera \"perspective\" WorldBegin\n"
            "ObjectBegin \"o\" Shape \"disk\" \"float height\" [ 3 ] Shape \"sphere\" ObjectEnd\n"
            "Shape \"sphere\"\n"
            "TransformBegin Translate 3 0 0 ObjectInstance \"o\" TransformEnd\n"
            "TransformBegin Translate -3 0 0 Scale 1 2 -.5 ObjectInstance \"o\" TransformEnd\n"
            "WorldEnd\n");
    f.write("rays.txt", "0 0 -9 0 0 1\n3 0 -9 0 0 1\n-3 0 -9 0 0 1\n-3 1.9 -9 0 0 1\n");
    for (const char* backend : {"none", "grid", "bvh", "embree", "embree-user"}) {
        const auto r = f.etalon(std::string("trace i.pbrt --rays rays.txt -b ") + backend);
        REQUIRE(r.status == 0);
        CHECK(r.out.find("hit 8 sphere 0 ") == 0);
        CHECK(r.out.find("\nhit 8 sphere 0/1 0 0 -1\n") != std::string::npos);
        CHECK(r.out.find("\nhit 7.5 ring 1/0 0 0 -1\n") != std::string::npos);
    }
    const json info = json::parse(f.etalon("info i.pbrt --json").out);
    CHECK(info["primitives"] == json{{"sphere", 2}, {"ring", 1}});
    CHECK(info["instances"] == 2);
    CHECK(info["objects"] == 1);
    const auto r = f.etalon("crosscheck i.pbrt --rays 500 -b grid,bvh,embree");
    CHECK(r.status == 0);
}

TEST_CASE("trace, info, convert and crosscheck know what moves", "[app]") {
    const Folder f;
    f.write("m.pbrt",
            "LookAt 0 0 -9  0 0 0  0 1 0 Camera \"perspective\" \"float shutterclose\" 0.5\n"
            "TransformTimes 0 1 WorldBegin Shape \"disk\" \"float height\" [ 3 ]\n"
            "ActiveTransform EndTime Translate 4 0 -4 ActiveTransform All Shape \"sphere\"\n"
            "WorldEnd\n");
    f.write("rays.txt",
            "0 0 -9 0 0 1\n-0.5 0 -9 0 0 1 0 100 0.5\n1 0 -9 0 0 1 0 100 0.5\n"
            "2 0 -9 0 0 1 0 100 0x1.fffffep-1\n");
    const auto check_traced = [&](const std::string& scene, const std::string& backend) {
        INFO(scene << " " << backend);
        const auto r = f.etalon("trace " + scene + " --rays rays.txt -b " + backend);
        REQUIRE(r.status == 0);
        CHECK(r.out.find("hit 8 sphere 0/0 0 0 -1\n") == 0);             // as the shutter opens
        CHECK(r.out.find("\nhit 12 ring 0 0 0 ") != std::string::npos);  // when it is half gone
        CHECK(r.out.find("\nhit 7 sphere 0/0 0 0 -1\n") != std::string::npos);
        CHECK(r.out.find("\nhit 6.00000") != std::string::npos);
    };
    for (const char* backend : {"none", "grid", "bvh", "embree", "embree-user"}) {
        check_traced("m.pbrt", backend);
    }
    REQUIRE(f.etalon("convert m.pbrt -o again.pbrt").status == 0);
    check_traced("again.pbrt", "bvh");
    const json info = json::parse(f.etalon("info m.pbrt --json").out);
    CHECK(info["needs"] == json{"time samples"});
    CHECK(info["diagnostics"].empty());
    CHECK(f.etalon("crosscheck m.pbrt --rays 500 -b grid,bvh,embree").status == 0);
}

TEST_CASE("trace, render and crosscheck know holes", "[app]") {
    const Folder f;
    const std::string square =
        "\"integer indices\" [ 0 1 2 0 2 3 ] \"float uv\" [ 0 0 1 0 1 1 0 1 ]\n"
        "\"point P\" [ -1 -1 0 1 -1 0 1 1 0 -1 1 0 ]\n";
    f.write("h.pbrt",
            "LookAt 0 0 -9  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 20\n"
            "Integrator \"path\" Sampler \"sobol\" \"integer pixelsamples\" 4\n"
            "Film \"image\" \"integer xresolution\" 32 \"integer yresolution\" 32\n"
            "WorldBegin LightSource \"distant\"\n"
            "Texture \"left\" \"float\" \"checkerboard\" \"float uscale\" 2 \"float vscale\" 0\n"
            "  \"float tex1\" 0 \"float tex2\" 1\n"
            "ObjectBegin \"o\" Shape \"trianglemesh\" \"texture shadowalpha\" \"left\" " +
                square + "ObjectEnd\nShape \"trianglemesh\" \"texture alpha\" \"left\" " + square +
                "Shape \"trianglemesh\" \"float alpha\" 0 " + square +
                "TransformBegin Translate 0 0 1 ObjectInstance \"o\" TransformEnd WorldEnd\n");
    f.write("rays.txt", "-0.5 0.1 -9 0 0 1\n0.5 0.1 -9 0 0 1\n");
    REQUIRE(f.etalon("render h.pbrt -q -b none -o h.exr").status == 0);
    for (const char* backend : {"none", "grid", "bvh", "embree", "embree-user"}) {
        CAPTURE(backend);
        const std::string trace = std::string("trace h.pbrt --rays rays.txt -b ") + backend;
        const auto seen = f.etalon(trace);
        REQUIRE(seen.status == 0);
        CHECK(seen.out.find("hit 10 triangle 0/1 ") == 0);
        CHECK(seen.out.find("\nhit 9 triangle 0 ") != std::string::npos);
        const auto shadow = f.etalon(trace + " --shadow");
        CHECK(shadow.out.find("miss\nhit 9 triangle 0 ") == 0);
        REQUIRE(f.etalon(std::string("render h.pbrt -q -o b.exr -b ") + backend).status == 0);
        CHECK(pixels(f.path("h.exr")) == pixels(f.path("b.exr")));
    }
    CHECK(f.etalon("crosscheck h.pbrt --rays 500 -b grid,bvh,embree").status == 0);
}

TEST_CASE("An image of instances is that of their copies, but for roundings", "[app]") {
    const Folder f;
    const std::string head =
        "LookAt 0 3 -9  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" [ 45 ] "
        "Film \"image\" \"integer xresolution\" [ 48 ] \"integer yresolution\" [ 48 ] "
        "Sampler \"random\" \"integer pixelsamples\" [ 4 ] Integrator \"path\" WorldBegin\n"
        "LightSource \"infinite\" \"rgb L\" [ 1 .9 .8 ] Shape \"disk\" \"float radius\" [ 9 ]\n";
    const std::string object =
        "Material \"uber\" Shape \"cone\" Shape \"sphere\" \"float radius\" [ .8 ]\n"
        "Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ] \"point P\" "
        "[ -1 -1 0  1 -1 0  1 1 .5  -1 1 0 ]\n";
    std::string instances = head + "ObjectBegin \"o\" " + object + "ObjectEnd\n", copies = head;
    for (const char* map : {"Translate 2 0 0", "Translate -2 0 1 Rotate 40 0 1 0 Scale 1 2 .25",
                            "Translate 0 1 3 Scale -2 1 1"}) {
        const std::string begin = std::string("AttributeBegin ") + map + " ";
        instances += begin + "ObjectInstance \"o\" AttributeEnd\n";
        copies += begin + object + "AttributeEnd\n";
    }
    f.write("instances.pbrt", instances + "WorldEnd\n");
    f.write("copies.pbrt", copies + "WorldEnd\n");
    REQUIRE(f.etalon("render instances.pbrt -q").status == 0);
    REQUIRE(f.etalon("render copies.pbrt -q").status == 0);
    const auto r =
        f.etalon("compare instances.exr copies.exr --json c.json --fail-above relmse=1e-6");
    CHECK(r.status == 0);
    const json same = json::parse(f.read("c.json"));
    for (const char* channel : {"mean_a", "mean_b"}) CHECK(same[channel][0] > .01);
}
