// render --tev, checked by an independent implementation of the protocol.
#include <algorithm>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/app/tev_listener.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

/// Returns the number of pixels that differ between an EXR and a viewer's image; all if the sizes
/// differ.
std::size_t differences(const ViewedImage& viewed, const std::string& exr) {
    const auto read = etalon::read_image(exr);
    REQUIRE(read.error == "");
    const etalon::Image& image = read.value;
    const Imath::V2i origin = image.origin.value_or(Imath::V2i(0));
    if (viewed.channels.size() != 3) return viewed.channels.at("R").size();
    std::size_t count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(origin.y + y) * viewed.width + origin.x + x;
            const etalon::Color color(viewed.channels.at("R")[i], viewed.channels.at("G")[i],
                                      viewed.channels.at("B")[i]);
            count += color != image.color(x, y);
        }
    }
    return count;
}

}  // namespace

TEST_CASE("a listener for tev's protocol has the image of the EXR in the end", "[app]") {
    for (const std::string options :
         {"--spp 16", "--spp 0", "--spp 4 --filter gaussian:2", "--target-error 1e-3", "--spd",
          "--spp 2 --crop 3,5,30,20", "--spp 2 --display-values", "--spp 2 --integrator path"}) {
        INFO(options);
        const Folder f;
        f.write("ball.p3f", small_scene);
        TevListener listener;
        const auto r =
            f.etalon("render ball.p3f -q -o a.exr --tev " + listener.address() + " " + options);
        CHECK(r.status == 0);
        CHECK(r.err == "");
        const auto images = listener.images();
        REQUIRE(images.size() == 1);
        REQUIRE(images.count("ball.p3f") == 1);
        const ViewedImage& image = images.at("ball.p3f");
        CHECK(image.width == 32);
        CHECK(image.height == 24);
        CHECK(image.updates >= 2);  // tiles
        CHECK(differences(image, f.path("a.exr")) == 0);
    }
}

TEST_CASE("an image sent to tev is the one rendered without it", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    TevListener listener;
    const std::string command = "render ball.p3f -q --spp 8 --filter mitchell:2 ";
    REQUIRE(f.etalon(command + "-o a.exr --tev " + listener.address()).status == 0);
    REQUIRE(f.etalon(command + "-o b.exr").status == 0);
    CHECK(f.etalon("compare a.exr b.exr --fail-above different_pixels=0").status == 0);
}

TEST_CASE("an interrupted image is sent as it was written", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    TevListener listener;
    const auto r =
        interrupted(f, "etalon render ball.p3f --spp 16777216 -o a.exr --tev " + listener.address(),
                    has_worked(50));
    CHECK(r.status == 130);
    CHECK(differences(listener.images().at("ball.p3f"), f.path("a.exr")) == 0);
}

TEST_CASE("without a listener rendering goes on, with one line of warning", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("render ball.p3f -q -o a.exr --tev 127.0.0.1:1");
    CHECK(r.status == 0);
    CHECK(r.err ==
          "etalon: warning: tev at 127.0.0.1:1: Connection refused; rendering goes on without "
          "it\n");
    CHECK(f.has("a.exr"));
}

TEST_CASE("a listener that closes or hangs ends no rendering", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q --resolution 1200x900 --spp 8 -o b.exr").status == 0);
    for (const auto manner :
         {TevListener::Manner::close_after_some, TevListener::Manner::read_nothing}) {
        TevListener listener(manner);
        const auto r = f.etalon("render ball.p3f -q --resolution 1200x900 --spp 8 -o a.exr --tev " +
                                listener.address());
        CHECK(r.status == 0);
        CHECK_THAT(r.err,
                   ContainsSubstring("etalon: warning: tev at " + listener.address() + ": "));
        CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
        CHECK(f.etalon("compare a.exr b.exr --fail-above different_pixels=0").status == 0);
    }
}

TEST_CASE("the address of tev may be left out, but not be wrong", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const std::string command :
         {"render --tev ball.p3f", "render ball.p3f --tev -o a.exr",
          "render ball.p3f --tev=127.0.0.1:14158", "render ball.p3f --tev localhost:14158"}) {
        INFO(command);
        CHECK(f.etalon(command).status == 0);
    }
    CHECK_THAT(f.etalon("render --tev ball.p3f -o a.exr").err,
               ContainsSubstring("ball.p3f: expected HOST:PORT; the scene comes before --tev"));
    for (const std::string address :
         {"nowhere", "localhost:", "localhost:0", "localhost:65536", ":14158", "localhost:14x"}) {
        const auto r = f.etalon("render ball.p3f --tev " + address + " -o a.exr");
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("--tev " + address + ": expected HOST:PORT"));
    }
}
