// render and etalon-bench convergence with references and limits.
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// Folder with a scene and a reference.exr of many samples.
struct Converging : Folder {
    Converging() {
        write("ball.p3f", small_scene);
        REQUIRE(etalon("render ball.p3f --spp 256 --seed 7 -q -o reference.exr").status == 0);
    }
    json stats() const { return json::parse(read("s.json")); }
};

}  // namespace

TEST_CASE("render --reference lists the error after each pass, and agrees with compare at the end",
          "[app]") {
    const Converging f;
    REQUIRE(f.etalon("render ball.p3f --spp 16 --reference reference.exr -q -o a.exr "
                     "--stats s.json")
                .status == 0);
    const json s = f.stats();
    REQUIRE(s["convergence"].size() == 5);
    double last = 1e9;
    int samples = 1;
    for (const json& point : s["convergence"]) {
        CHECK(point["relmse"] < last);
        CHECK(point["spp"] == samples);
        CHECK(point["cpu_seconds"].is_number());
        last = point["relmse"];
        samples *= 2;
    }
    REQUIRE(f.etalon("compare a.exr reference.exr --json c.json").status == 0);
    CHECK(s["error"] == json::parse(f.read("c.json")));
}

TEST_CASE("The last pass has the samples of the image, with a filter wider than a pixel too",
          "[app]") {
    const Converging f;
    REQUIRE(f.etalon("render ball.p3f --target-error 2e-5 --filter gaussian --reference "
                     "reference.exr -q -o a.exr --stats s.json")
                .status == 0);
    CHECK(f.stats()["convergence"].back()["spp"] == f.stats()["image"]["spp"]);
}

TEST_CASE("render --target-error stops there, however many samples that takes", "[app]") {
    const Converging f;
    const auto r = f.etalon(
        "render ball.p3f --target-error 2e-3 --reference reference.exr "
        "-o a.exr --stats s.json");
    REQUIRE(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("relMSE") && ContainsSubstring("samples a pixel"));
    const json s = f.stats();
    CHECK(s["expected_error"]["relmse"] <= 2e-3 * 1.03);
    CHECK(s["error"]["relmse"] < 4e-3);
    CHECK(s["image"]["spp"] < 256);
}

TEST_CASE("a reference serves a crop, and one of another size is refused", "[app]") {
    const Converging f;
    REQUIRE(f.etalon("render ball.p3f --spp 256 --seed 7 --crop 3,4,20,15 -q -o a.exr "
                     "--reference reference.exr --stats s.json")
                .status == 0);
    CHECK(f.stats()["error"]["max_abs"] == 0);
    const auto r = f.etalon("render ball.p3f --resolution 9x9 --reference reference.exr -o b.exr");
    CHECK(r.status == 3);
    CHECK_THAT(r.err,
               ContainsSubstring("reference.exr: 32 x 24 pixels at 0,0 of a frame of 32 x 24; "
                                 "expected 9 x 9 at 0,0, or all, of a frame of 9 x 9"));
    CHECK_FALSE(f.has("b.exr"));
    CHECK(f.etalon("render ball.p3f --crop 1,1,18,12 --reference a.exr -o b.exr").status == 3);
    CHECK(f.etalon("render ball.p3f --reference nowhere.exr").status == 3);
}

TEST_CASE("a reference of as many pixels from elsewhere, or of another frame, is refused",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string render = "render ball.p3f --spp 1 -q -o ";
    REQUIRE(f.etalon(render + "a.exr --resolution 100x100 --crop 50,50,70,60").status == 0);
    REQUIRE(f.etalon(render + "b.exr --resolution 60x80 --crop 10,10,30,20").status == 0);
    CHECK(f.etalon(render + "c.exr --resolution 20x10 --reference a.exr").status == 3);
    CHECK(f.etalon(render + "c.exr --resolution 100x100 --crop 10,10,30,20 --reference b.exr")
              .status == 3);
    CHECK_FALSE(f.has("c.exr"));
    REQUIRE(
        f.etalon(render + "c.exr --resolution 60x80 --crop 10,10,30,20 --reference b.exr").status ==
        0);
}

TEST_CASE("an invalid error, time or sampler is wrong usage", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const std::string wish :
         {"--target-error 0", "--target-error -1", "--target-error x", "--time-limit 0",
          "--sampler even", "--spp 0 --target-error 0.1", "--spd --target-error 0.1"}) {
        INFO(wish);
        CHECK(f.etalon("render ball.p3f " + wish).status == 2);
    }
}

TEST_CASE("render --time-limit ends an endless rendering with a complete image", "[app]") {
    const Converging f;
    constexpr int endless = 1 << 24;
    const auto r = f.etalon("render ball.p3f --time-limit 0.2 --spp " + std::to_string(endless) +
                            " -q -o a.exr --stats s.json");
    CHECK(r.status == 0);
    CHECK(f.stats()["image"]["spp"] >= 1);
    CHECK(f.stats()["image"]["spp"] < endless);
    CHECK(f.etalon("compare a.exr reference.exr --fail-above relmse=0.2").status == 0);
}

TEST_CASE("a time limit that is too short gives an image of one sample per pixel", "[app]") {
    const Converging f;
    const auto r = f.etalon(
        "render ball.p3f --time-limit 1e-300 --reference reference.exr -o a.exr "
        "--stats s.json");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("relMSE"));
    CHECK(f.has("a.exr"));
    CHECK(f.stats()["image"]["spp"] == 1);
    CHECK(f.stats()["convergence"].size() == 1);
}

TEST_CASE("a PNG is a reference", "[app]") {
    const Converging f;
    REQUIRE(f.etalon("render ball.p3f --spp 256 --seed 7 -q -o reference.png").status == 0);
    REQUIRE(f.etalon("render ball.p3f --spp 64 --reference reference.png -q -o a.exr "
                     "--stats s.json")
                .status == 0);
    CHECK(f.stats()["error"]["relmse"] < 2e-3);
    REQUIRE(f.shell("exec '" ETALON_BINARY_DIR "/bin/etalon-bench' convergence ball.p3f --spp 64 "
                    "--samplers sobol --seeds 1 --reference reference.png --json c.json")
                .status == 0);
    CHECK(json::parse(f.read("c.json"))["curves"][0]["points"].back()["relmse"] < 2e-3);
}

TEST_CASE("convergence has a curve for every sampler and backend", "[app]") {
    const Converging f;
    const auto r = f.shell("exec '" ETALON_BINARY_DIR
                           "/bin/etalon-bench' convergence ball.p3f "
                           "--spp 16 --seeds 2 --backends bvh,grid --json c.json");
    REQUIRE(r.status == 0);
    const json j = json::parse(f.read("c.json"));
    CHECK(j["reference"] == "512 samples per pixel");
    REQUIRE(j["curves"].size() == 4);
    for (const json& curve : j["curves"]) {
        INFO(curve["name"]);
        CHECK_THAT(r.out, ContainsSubstring(std::string(curve["name"])));
        CHECK(curve["points"].size() >= 5);
        CHECK(curve["slope"] < -0.5);
        CHECK(curve["efficiency"] > 0);
    }
    for (const json& curve : j["curves"]) CHECK(curve["integrator"] == "whitted");
    const auto last = [&](int curve) { return j["curves"][curve]["points"].back()["mse"]; };
    CHECK(last(1) < last(0));  // sobol, random
    CHECK(f.shell("'" ETALON_BINARY_DIR "/bin/etalon-bench' convergence nothing.p3f").status == 3);
}

TEST_CASE("convergence renders with every requested integrator", "[app]") {
    const Converging f;
    const std::string command =
        "exec '" ETALON_BINARY_DIR "/bin/etalon-bench' convergence ball.p3f --samplers sobol ";
    REQUIRE(f.shell(command + "--integrators whitted,ao --spp 16 --seeds 1 --json c.json").status ==
            0);
    const json j = json::parse(f.read("c.json"));
    REQUIRE(j["curves"].size() == 2);
    for (int i : {0, 1}) {
        const json& points = j["curves"][i]["points"];
        CHECK(j["curves"][i]["integrator"] == (i == 0 ? "whitted" : "ao"));
        CHECK(points.back()["mse"] < points.front()["mse"]);  // each against a separate reference
    }
    CHECK(j["curves"][0]["points"][0]["mse"] != j["curves"][1]["points"][0]["mse"]);
    const auto unknown = f.shell(command + "--integrators bdpt");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("one of auto, whitted"));
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("path, volpath, ao"));
}

TEST_CASE("an error without an estimate is unknown in text and null in JSON", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const std::string limit : {"--spp 1", "--time-limit 1e-300"}) {
        INFO(limit);
        const auto r =
            f.etalon("render ball.p3f --target-error 0.01 " + limit + " -o a.exr --stats s.json");
        REQUIRE(r.status == 0);
        CHECK_THAT(r.err, ContainsSubstring("1.0 samples a pixel, relMSE unknown"));
        const auto missed = ContainsSubstring("--target-error 0.01 needs a larger --spp");
        if (limit == "--spp 1") CHECK_THAT(r.err, missed);
        if (limit != "--spp 1") CHECK_THAT(r.err, !missed);
        const json s = json::parse(f.read("s.json"));
        CHECK(s["target_error"] == 0.01);
        CHECK(s["expected_error"].at("relmse").is_null());
        CHECK(s["stopped"] == (limit == "--spp 1" ? json() : json("time-limit")));
        const Imf::InputFile file(f.path("a.exr").c_str());
        CHECK(file.header().findTypedAttribute<Imf::FloatAttribute>("expectedError") == nullptr);
    }
    REQUIRE(f.etalon("render ball.p3f --spp 2 -q -o a.exr --stats s.json").status == 0);
    const json s = json::parse(f.read("s.json"));
    CHECK(s.at("target_error").is_null());
    CHECK(s.at("expected_error").at("relmse").is_null());
    CHECK(s.at("stopped").is_null());
    const Imf::InputFile whole(f.path("a.exr").c_str());
    CHECK(whole.header().findTypedAttribute<Imf::StringAttribute>("stopped") == nullptr);
    CHECK(whole.header().typedAttribute<Imf::FloatAttribute>("samplesPerPixel").value() == 2);
}

TEST_CASE("a target error that --spp does not allow is said, and is no failure", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r =
        f.etalon("render ball.p3f --target-error 1e-9 --spp 13 -q -o a.exr --stats s.json");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("ball.p3f: warning: relMSE ") &&
                          ContainsSubstring(" expected after 13.0 samples per pixel"));
    const json s = json::parse(f.read("s.json"));
    CHECK(s["stopped"].is_null());
    CHECK(s["image"]["spp"] == 13);
    CHECK(s["expected_error"]["relmse"] > 1e-9);
}

TEST_CASE("an error that was estimated stands in the image and in the figures alike", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --target-error 1e-4 -q -o a.exr --stats s.json").status == 0);
    const json s = json::parse(f.read("s.json"));
    CHECK(s["stopped"].is_null());
    const Imf::InputFile file(f.path("a.exr").c_str());
    const auto number = [&](const char* name) {
        return file.header().typedAttribute<Imf::FloatAttribute>(name).value();
    };
    CHECK(number("targetError") == 1e-4F);
    CHECK(number("expectedError") == s["expected_error"]["relmse"].get<float>());
    CHECK(number("samplesPerPixel") == s["image"]["spp"].get<float>());
    CHECK(s["image"]["spp"] != std::round(s["image"]["spp"].get<double>()));  // it is adaptive
}

TEST_CASE("an image ended by a signal or the time limit is marked as such", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::string command = "render ball.p3f --spp 10000000 -o a.exr --stats s.json ";
    const auto r =
        f.shell("'" ETALON_BINARY_DIR "/bin/etalon' " + command +
                "& pid=$!; while kill -0 $pid && test $(cut -d ' ' -f 14 "
                "/proc/$pid/stat) -lt 50; do sleep 0.05; done; kill -INT $pid; wait $pid");
    CHECK(r.status == 130);
    CHECK_THAT(r.err, ContainsSubstring("stopped: signal"));
    for (const std::string why : {"signal", "time-limit"}) {
        INFO(why);
        const json s = json::parse(f.read("s.json"));
        CHECK(s["stopped"] == why);
        CHECK(s["image"]["spp"] > 1);
        CHECK(s["image"]["spp"] < 10000000);
        const Imf::InputFile file(f.path("a.exr").c_str());
        CHECK(file.header().typedAttribute<Imf::StringAttribute>("stopped").value() == why);
        const std::string limit = is_sanitized ? "2" : "0.2";
        REQUIRE(f.etalon(command + "-q --time-limit " + limit).status == 0);
    }
}

TEST_CASE("an EXR has the aspect of pixels that are not square", "[app]") {
    const Folder f;
    const auto aspect = [&](const std::string& camera, const std::string& size) {
        f.write("a.pbrt",
                "Camera \"perspective\" " + camera + " WorldBegin Shape \"sphere\" WorldEnd");
        REQUIRE(f.etalon("render a.pbrt --spp 1 -q -o a.exr --resolution " + size).status == 0);
        return Imf::InputFile(f.path("a.exr").c_str()).header().pixelAspectRatio();
    };
    CHECK(aspect("", "30x20") == 1);
    CHECK(aspect("\"float frameaspectratio\" 1", "20x20") == 1);
    CHECK(aspect("\"float screenwindow\" [-1 1 -1 1]", "40x20") == Approx(0.5));
    CHECK(aspect("\"float screenwindow\" [-1 1 -1 1]", "20x40") == Approx(2));
}

TEST_CASE("Pixel aspect: given a realistic camera and any size, then pixels are square", "[app]") {
    const Folder f;
    f.write("lens.dat", "35 3 1.6 20\n-35 5 1 20\n0 30 0 15\n");
    const auto aspect = [&](const std::string& parameters, const std::string& size) {
        f.write("a.pbrt",
                "Film \"image\" \"integer xresolution\" 64 \"integer yresolution\" 48\n"
                "Camera \"realistic\" \"float aperturediameter\" 4 " +
                    parameters + " WorldBegin Shape \"sphere\" WorldEnd");
        REQUIRE(f.etalon("render a.pbrt --spp 1 -q -o a.exr --resolution " + size).status == 0);
        return Imf::InputFile(f.path("a.exr").c_str()).header().pixelAspectRatio();
    };
    for (const std::string camera : {"\"string lensfile\" \"lens.dat\"", ""}) {
        for (const std::string size : {"64x48", "20x40"}) {
            CAPTURE(camera, size);
            CHECK(aspect(camera, size) == 1);
        }
    }
}
