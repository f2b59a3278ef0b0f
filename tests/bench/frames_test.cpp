// etalon-bench frames: the stages of a frame, and the recorded rays.
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "bench/frames/fill_film.h"
#include "bench/frames/recorded_rays.h"
#include "bench/frames/scene_names.h"
#include "bench/scenes/bench_scene.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

using nlohmann::json;

namespace {

ProgramResult run_frames(const Folder& folder, const std::string& arguments) {
    return folder.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' frames " + arguments);
}

/// Counts the rays passed to it.
class CountingBackend : public BatchIntersector {
  public:
    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override {
        nearest += rays.size();
        std::ranges::fill(hits, Hit{2, 7});
    }
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        shadow += rays.size();
        std::ranges::fill(blocked, std::uint8_t{1});
    }

    using BatchIntersector::closest, BatchIntersector::occluded;

    mutable std::size_t nearest = 0, shadow = 0;
};

}  // namespace

TEST_CASE("Scenes of the same file name are told apart by their folders") {
    const std::vector<std::string> scenes{"x/a/scene.pbrt", "x/b/scene.pbrt", "soup:100",
                                          "y/b/scene.pbrt", "ball.p3f",       "ball.pbrt"};
    const auto name = [&](int i) { return frames::short_name(scenes[i], scenes); };
    CHECK(name(0) == "a/scene");
    CHECK(name(1) == "x/b/scene");
    CHECK(name(2) == "soup:100");
    CHECK(name(3) == "y/b/scene");
    CHECK(name(4) == "ball.p3f");
    CHECK(name(5) == "ball.pbrt");
    CHECK(frames::short_name("x/ball.p3f", {"x/ball.p3f", "x/ball.p3f"}) == "ball");
    CHECK(frames::short_name("a/s.p3f", {"a/s.p3f", "/a/s.p3f"}) == "a/s.p3f");
    CHECK(frames::short_name("/a/s.p3f", {"a/s.p3f", "/a/s.p3f"}) == "/a/s.p3f");
}

TEST_CASE("frames: given scenes, then each has its parts, and the rendering holds most of them") {
    const Folder f;
    const auto r = run_frames(f, "spheres:200 flake:100 --width 60 --repeat 1 --json f.json");
    REQUIRE(r.status == 0);
    const json j = json::parse(f.read("f.json"));
    REQUIRE(j["frames"].size() == 2);
    for (const json& frame : j["frames"]) {
        CAPTURE(frame.dump());
        CHECK(frame["rays"] > 60 * 30);
        CHECK(frame["width"] == 60);
        CHECK(frame["spp"] == 1);  // one ray through each pixel
        const json& cpu = frame["cpu_seconds"];
        for (const char* part : {"load", "build", "camera", "intersection", "render", "write"}) {
            CHECK(cpu[part] > 0);
        }
        CHECK(frame["overhead"] == double(cpu["render"]) / double(cpu["intersection"]));
    }
    CHECK(j["frames"][0]["scene"] == "spheres:200");
}

TEST_CASE(
    "frames: given a crop window and a width, then the window is the same part of the image") {
    const Folder f;
    f.write("crop.pbrt", R"(Film "image" "integer xresolution" 400 "integer yresolution" 400
"float cropwindow" [0.25 0.75 0.25 0.75]
Sampler "random" "integer pixelsamples" 4
WorldBegin
LightSource "infinite"
WorldEnd
)");
    REQUIRE(run_frames(f, "crop.pbrt --width 40 --repeat 1 --json f.json").status == 0);
    const json frame = json::parse(f.read("f.json"))["frames"][0];
    CHECK(frame["width"] == 40);
    CHECK(frame["rays"] == 20 * 20 * 4);  // the camera's, as there is nothing to hit
}

TEST_CASE("frames: given what is no scene, then the status says so") {
    const Folder f;
    CHECK(run_frames(f, "nowhere.p3f").status == 3);
    CHECK(run_frames(f, "spheres:10 -b bvhh").status == 2);
    CHECK(run_frames(f, "").status == 2);
    const auto late = run_frames(f, "spheres:10 typo.p3f --json f.json");
    CHECK(late.status == 3);
    CHECK(late.out.empty());
    CHECK_FALSE(f.has("f.json"));
}

TEST_CASE("frames: given a scene that cannot be read, then those before it are written") {
    const Folder f;
    f.write("bad.p3f", "nonsense\n");
    const auto r = run_frames(f, "spheres:20 bad.p3f --width 20 --repeat 1 --json f.json");
    CHECK(r.status == 3);
    CHECK_THAT(r.out, ContainsSubstring("spheres:20") && ContainsSubstring("Stopped by an error"));
    const json j = json::parse(f.read("f.json"));
    CHECK(j["stopped"] == "error");
    CHECK(j["frames"].size() == 1);
}

TEST_CASE(
    "frames: given several backends, then each has its ratio to embree-builtin, or the first") {
    const Folder f;
    const std::string run = "spheres:20 --width 20 --repeat 2 --json f.json --backends ";
    const auto check_ratios = [&](const std::string& backends, std::size_t baseline) {
        const auto r = run_frames(f, run + backends);
        REQUIRE(r.status == 0);
        const json all = json::parse(f.read("f.json"))["frames"];
        REQUIRE(all.size() == 2);
        for (const json& frame : all) {
            CHECK_THAT(r.out,
                       ContainsSubstring("\n  " + frame["backend"].get<std::string>() + " "));
            CHECK(frame["repeats"] == 2);
            CHECK(frame["ratio"] == double(all[baseline]["cpu_seconds"]["render"]) /
                                        double(frame["cpu_seconds"]["render"]));
        }
    };
    check_ratios("bvh,embree-builtin", 1);
    check_ratios("grid,bvh", 0);
}

TEST_CASE("frames: given a file that cannot be written, then the message has the program's name") {
    const Folder f;
    const auto r = run_frames(f, "spheres:20 --width 20 --repeat 1 --json /dev/full");
    CHECK(r.status == 4);
    CHECK_THAT(r.err, ContainsSubstring("etalon-bench: error: /dev/full: cannot be written"));
}

TEST_CASE("frames: given no folder for temporary files, then it ends before it measures") {
    const Folder f;
    for (const char* folder : {"/nonexistent", "/proc"}) {
        const auto r = f.shell(std::string("TMPDIR=") + folder +
                               " exec '" ETALON_BINARY_DIR
                               "/bin/etalon-bench' frames spheres:20 --json f.json");
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring("no folder for temporary files"));
        CHECK_FALSE(f.has("f.json"));
    }
}

TEST_CASE("frames: given a folder for temporary files, then nothing is left in it") {
    const Folder f;
    const auto r = f.shell("mkdir t; TMPDIR=t '" ETALON_BINARY_DIR
                           "/bin/etalon-bench' frames spheres:20 --width 20 --repeat 1; ls -A t");
    CHECK(r.status == 0);
    CHECK_THAT(r.out, !ContainsSubstring("etalon-"));
}

TEST_CASE(
    "A frame's film: given an image with a filter, then it is filled as when it is rendered") {
    RenderSettings settings;
    settings.resolution = {9, 7};
    Film image(settings.window());
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 9; ++x) {
            for (int n = 0; n < 3; ++n) image.add(x, y, Color(1));
        }
    }
    for (const bool is_wide : {false, true}) {
        if (is_wide) settings.filter = {FilterKind::gaussian, Vec2(2)};
        ImageFilm film(settings.window(), settings);
        REQUIRE(film.is_filtered() == is_wide);
        CHECK(frames::fill_film(film, image) > 0);
        CHECK(film.samples().total_count() == 3 * film.samples().size());
        const Film done = film.is_filtered() ? film.filtered() : film.samples();
        CHECK(done.mean(done.index(4, 3)).x == Approx(0.5));
    }
}

TEST_CASE("RecordedRays: given batches, then all are answered and every n-th is asked again") {
    const CountingBackend backend;
    const frames::RecordedRays recorded(backend, 3);
    const std::vector<Ray> rays(10);
    std::vector<Hit> hits(10);
    std::vector<std::uint8_t> blocked(10);
    for (int i = 0; i < 7; ++i) recorded.closest(rays, hits);
    for (int i = 0; i < 3; ++i) recorded.occluded(std::span(rays).first(4), blocked);
    CHECK((hits[9].primitive == 7 && blocked[3] == 1));
    CHECK(backend.nearest == 70);
    CHECK(backend.shadow == 12);
    CHECK(recorded.replay() >= 0);
    CHECK(backend.nearest == 70 + 30);  // the first, fourth and seventh batch
    CHECK(backend.shadow == 12 + 4);
}

TEST_CASE("RecordedRays: given streams, then they are kept whole") {
    const CountingBackend backend;
    const frames::RecordedRays recorded(backend, 2);
    std::vector<Hit> hits(10);
    std::vector<std::uint8_t> blocked(10);
    {
        RayBuffer rays;
        rays.make_room(10);
        for (int i = 0; i < 3; ++i) recorded.closest(rays.view(10), hits);
        recorded.occluded(rays.view(7), blocked);
    }
    CHECK((backend.nearest == 30 && backend.shadow == 7));
    CHECK(recorded.replay() >= 0);
    CHECK((backend.nearest == 30 + 20 && backend.shadow == 7 + 7));
}
