// Features that all subcommands must support: instances, motion and holes.
#include <nlohmann/json.hpp>

#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

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

TEST_CASE("trace, info, convert and crosscheck support motion", "[app]") {
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
        CHECK(r.out.find("hit 8 sphere 0/0 0 0 -1\n") == 0);  // when the shutter opens
        CHECK(r.out.find("\nhit 12 ring 0 0 0 ") !=
              std::string::npos);  // in the middle of the interval
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
