// etalon compare as a process: its output for two images, and its exit status.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <nlohmann/json.hpp>

#include "core/image/io.h"
#include "core/image/metrics/magma.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/image/formula_images.h"

using namespace etalon::test;
using etalon::Color;
using Json = nlohmann::ordered_json;

namespace {

using Pixels = std::vector<Color>;

/// Writes into a window of a frame that ends where it does.
void write(const Folder& f, const std::string& name, int width, const Pixels& pixels,
           Imath::V2i origin = {0, 0}) {
    const Imath::V2i size(width, static_cast<int>(pixels.size()) / width), end = origin + size;
    const etalon::RenderedImage image{end.x,  end.y, {origin, end - Imath::V2i(1)},
                                      pixels, false, {}};
    REQUIRE(etalon::write_image(f.path(name), image) == "");
}

Json json_of(const Folder& f, const std::string& arguments) {
    const auto r = f.etalon("compare " + arguments + " --json -");
    INFO(r.err);
    REQUIRE(r.status == 0);
    return Json::parse(r.out);
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("compare reports that an image equals itself", "[app]") {
    const Folder f;
    write(f, "a.exr", 40, stripes(40, 30));
    const Json json = json_of(f, "a.exr a.exr");
    CHECK(json.dump() ==
          R"({"mse":0.0,"relmse":0.0,"mae":0.0,"psnr":null,"ssim":1.0,"flip":0.0,"max_abs":0.0,)"
          R"("different_pixels":0,"mean_a":)" +
              json["mean_a"].dump() + R"(,"mean_b":)" + json["mean_a"].dump() + "}");
    const auto table = f.etalon("compare a.exr a.exr --json a.json");
    CHECK(table.status == 0);
    CHECK(table.err == "");
    CHECK_THAT(table.out, ContainsSubstring("\npsnr                       inf  dB"));
    CHECK(Json::parse(f.read("a.json")) == json);
}

TEST_CASE("compare takes the second image as the reference", "[app]") {
    const Folder f;
    write(f, "a.exr", 2, {{1, 0.5F, 0}, {0.25F, 2, 3}});
    write(f, "b.exr", 2, {{0.5F, 0.5F, 0.25F}, {0.25F, 0, 3}});
    const Json json = json_of(f, "a.exr b.exr");
    CHECK(json["mse"] == (0.25 + 0.0625 + 4) / 6);
    CHECK(json["relmse"].get<double>() ==
          Approx((0.25 / 0.26 + 0.0625 / 0.0725 + 4 / 0.01) / 6).epsilon(1e-12));
    CHECK(json["mae"] == (0.5 + 0.25 + 2) / 6);
    CHECK(json["max_abs"] == 2.0);
    CHECK(json["different_pixels"] == 2);
    CHECK(json["mean_a"].dump() == "[0.625,1.25,1.5]");
    CHECK(json["mean_b"].dump() == "[0.375,0.25,1.625]");
    CHECK(json["psnr"].get<double>() == Approx(-10 * std::log10(4.3125 / 6)).epsilon(1e-12));
}

TEST_CASE("compare finds a PNG and the EXR it was made of alike, to the PNG's steps", "[app]") {
    const Folder f;
    write(f, "a.exr", 40, stripes(40, 30));
    write(f, "a.png", 40, stripes(40, 30));
    const Json json = json_of(f, "a.png a.exr");
    CHECK(json["max_abs"] < 0.5 / 255 * 2.4);  // the curve's steepest
    CHECK(json["max_abs"] > 0.0);
    CHECK(json["flip"] < 0.01);
    CHECK(json["ssim"] > 0.999);
}

TEST_CASE("compare exits with 1 if a metric is worse than its limit, and names it", "[app]") {
    const Folder f;
    write(f, "a.exr", 40, stripes(40, 30));
    write(f, "b.exr", 40, rings(40, 30));
    const Json json = json_of(f, "a.exr b.exr");
    const auto with = [&](const std::string& limits) {
        return f.etalon("compare " + limits + " a.exr b.exr --json a.json");
    };
    for (const auto& item : json.items()) {
        const std::string& name = item.key();  // clang 14 captures no structured binding
        const Json& value = item.value();
        if (!value.is_number()) continue;
        INFO(name);
        const bool falls = name == "psnr" || name == "ssim";
        const auto x = value.get<double>();
        const auto limit = [&](double v) { return "--fail-above " + name + "=" + Json(v).dump(); };
        CHECK(with(limit(x)).status == 0);
        CHECK(with(limit(falls ? x * 0.99 : x * 1.01)).status == 0);
        const auto worse = with(limit(falls ? x * 1.01 : x * 0.99));
        CHECK(worse.status == 1);
        CHECK_THAT(worse.err, ContainsSubstring("etalon: error: " + name + " is ") &&
                                  ContainsSubstring(falls ? ", below " : ", above "));
    }
    const auto several = with("--fail-above mse=0 --fail-above flip=1 --fail-above psnr=inf");
    CHECK(several.status == 1);
    CHECK_THAT(several.err, ContainsSubstring("mse is ") && ContainsSubstring("psnr is ") &&
                                !ContainsSubstring("flip"));
    CHECK(Json::parse(f.read("a.json")) == json);
}

TEST_CASE("compare knows a limit that cannot be meant", "[app]") {
    const Folder f;
    write(f, "a.exr", 2, stripes(2, 2));
    const auto misspelt = f.etalon("compare a.exr a.exr --fail-above remlse=1");
    CHECK(misspelt.status == 2);
    CHECK_THAT(misspelt.err, ContainsSubstring("--fail-above remlse: expected") &&
                                 ContainsSubstring("max_abs") &&
                                 ContainsSubstring("did you mean 'relmse'?"));
    for (const char* text : {"mse", "mse=", "mse=x", "mse=1x", "mse=nan", "=1", "mean_a=1"}) {
        INFO(text);
        CHECK(f.etalon(std::string("compare a.exr a.exr --fail-above ") + text).status == 2);
    }
    CHECK(f.etalon("compare a.exr").status == 2);
    CHECK(f.etalon("compare a.exr a.exr --heatmap map.exr").status == 2);
}

TEST_CASE("compare rejects images of different sizes or positions, and reports both", "[app]") {
    const Folder f;
    write(f, "a.exr", 4, stripes(4, 3));
    write(f, "b.png", 4, stripes(4, 5));
    write(f, "c.exr", 4, stripes(4, 3), {7, 2});
    write(f, "c.png", 4, stripes(4, 3), {7, 2});
    const auto size = f.etalon("compare a.exr b.png --json a.json");
    CHECK(size.status == 3);
    CHECK_THAT(size.err, ContainsSubstring("a.exr: 4 x 3 pixels at 0,0") &&
                             ContainsSubstring("b.png: 4 x 5 pixels;"));
    const auto place = f.etalon("compare a.exr c.exr");
    CHECK(place.status == 3);
    CHECK_THAT(place.err, ContainsSubstring("a.exr: 4 x 3 pixels at 0,0") &&
                              ContainsSubstring("c.exr: 4 x 3 pixels at 7,2"));
    CHECK(f.etalon("compare c.exr c.exr").status == 0);
    CHECK(f.etalon("compare c.exr c.png").status == 0);
    CHECK(f.etalon("compare a.exr c.png").status == 3);  // no overlap
    CHECK_FALSE(f.has("a.json"));
}

TEST_CASE("compare of a crop with the whole image, or another crop, compares their overlap",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& arguments) {
        CHECK(f.etalon("render ball.p3f --spp 1 -q " + arguments).status == 0);
    };
    render("-o all.exr -o all.png");
    render("--crop 8,6,24,20 -o crop.exr -o crop.png");
    render("--crop 16,0,32,12 -o other.exr");
    render("--resolution 64x48 -o large.exr");
    for (const char* pair : {"crop.exr all.exr", "all.exr crop.exr", "crop.png all.png",
                             "all.png crop.png", "crop.exr other.exr"}) {
        INFO(pair);
        CHECK(json_of(f, pair)["max_abs"] == 0.0);
    }
    for (const char* pair : {"crop.png all.exr", "crop.exr all.png", "other.exr crop.png"}) {
        INFO(pair);
        CHECK(json_of(f, pair)["max_abs"] <= 2.3 / 255);
    }
    CHECK_THAT(f.etalon("compare crop.png other.exr").err,
               ContainsSubstring("note: compared are the 8 x 6 pixels at 16,6"));
    CHECK(f.etalon("compare all.exr large.exr").status == 3);
    CHECK(f.etalon("compare crop.exr large.exr").status == 3);
    render("--resolution 64x48 --crop 8,6,24,20 -o same_place.exr");
    const auto r = f.etalon("compare crop.exr same_place.exr");
    CHECK(r.status == 3);
    CHECK_THAT(r.err, ContainsSubstring(
                          "crop.exr: 16 x 14 pixels at 8,6 of a frame of 32 x 24 pixels at "
                          "0,0; same_place.exr: 16 x 14 pixels at 8,6 of a frame of 64 x 48"));
}

TEST_CASE("compare tells frames of one size apart by their places", "[app]") {
    const Folder f;
    std::vector<float> pixels(4 * 4, 0.5F);
    const auto write_at = [&](const std::string& name, const Imath::Box2i& frame) {
        Imf::Header header(frame, Imath::Box2i({0, 0}, {3, 3}));
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        Imf::OutputFile file(f.path(name).c_str(), header);
        Imf::FrameBuffer buffer;
        buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), header.dataWindow()));
        file.setFrameBuffer(buffer);
        file.writePixels(4);
    };
    write_at("a.exr", {{0, 0}, {9, 9}});
    write_at("b.exr", {{-3, -3}, {6, 6}});
    CHECK(f.etalon("compare a.exr a.exr").status == 0);
    CHECK(f.etalon("compare a.exr b.exr").status == 3);
}

TEST_CASE("compare says in JSON which pixels it has compared", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q -o whole.exr").status == 0);
    REQUIRE(f.etalon("render ball.p3f -q --crop 4,2,20,12 -o crop.exr").status == 0);
    const auto window = [&](const std::string& images) {
        const auto r = f.etalon("compare " + images + " --json -");
        REQUIRE(r.status == 0);
        return nlohmann::json::parse(r.out).value("window", nlohmann::json());
    };
    CHECK(window("crop.exr whole.exr") == nlohmann::json{4, 2, 20, 12});
    CHECK(window("whole.exr whole.exr").is_null());
}

TEST_CASE("compare reports why it cannot read a file", "[app]") {
    const Folder f;
    write(f, "a.exr", 40, stripes(40, 30));
    f.write("cut.exr", f.read("a.exr").substr(0, 700));
    f.write("text.png", "not a picture");
    f.shell("mkdir folder");
    for (const std::string bad : {"none.exr", "cut.exr", "text.png", "folder"}) {
        INFO(bad);
        const auto first = f.etalon("compare " + bad + " a.exr");
        CHECK(first.status == 3);
        CHECK_THAT(first.err, ContainsSubstring("error: " + bad + ": "));
        CHECK(f.etalon("compare a.exr " + bad).status == 3);
    }
}

TEST_CASE("compare draws where the difference is seen", "[app]") {
    const Folder f;
    Pixels changed = stripes(60, 30);
    changed[15 * 60 + 10] = Color(1, 1, 1);
    write(f, "a.exr", 60, stripes(60, 30));
    write(f, "b.exr", 60, changed);
    CHECK(f.etalon("compare a.exr b.exr --heatmap map.png").status == 0);
    const auto map = etalon::read_image(f.path("map.png"));
    REQUIRE(map.error == "");
    CHECK(map.value.width == 60);
    CHECK(map.value.height == 30);
    const auto& bytes = std::get<etalon::PixelBytes>(map.value.pixels);
    const auto color = [&](int x, int y) {
        const auto* p = &bytes[3 * (y * 60 + x)];
        return std::array<std::uint8_t, 3>{p[0], p[1], p[2]};
    };
    CHECK(color(40, 15) == etalon::magma(0));
    CHECK(color(10, 15)[0] > 100);
}

TEST_CASE("compare writes its files whole or not at all", "[app]") {
    const Folder f;
    write(f, "a.exr", 4, stripes(4, 3));
    for (const char* output : {"--json no/such.json", "--heatmap no/such.png"}) {
        INFO(output);
        const auto r = f.etalon(std::string("compare a.exr a.exr ") + output);
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring(": cannot be written: no is not a directory"));
    }
    CHECK(f.shell("ls -A").out == "a.exr\n");
}

TEST_CASE("compare counts a NaN as an infinite difference", "[app]") {
    const Folder f;
    Pixels broken = stripes(20, 20);
    broken[50].y = not_a_number;
    broken[70].x = std::numeric_limits<float>::infinity();
    write(f, "a.exr", 20, broken);
    write(f, "b.exr", 20, stripes(20, 20));
    const auto r = f.etalon("compare a.exr b.exr --json - --fail-above mse=1e300");
    CHECK(r.status == 1);
    CHECK_THAT(r.err, ContainsSubstring("a.exr: warning: 2 pixels are NaN or infinite") &&
                          ContainsSubstring("mse is inf, above 1e+300"));
    const Json json = Json::parse(r.out);
    CHECK(json["different_pixels"] == 2);
    for (const char* key : {"mse", "relmse", "mae", "max_abs", "psnr"}) CHECK(json[key].is_null());
    CHECK(json["mean_a"][0].is_null());
    CHECK(json["mean_a"][2].is_number());
    CHECK(json["flip"].is_number());
    CHECK(json["ssim"].is_number());
    CHECK(json_of(f, "a.exr a.exr")["mse"] == 0);
}
