#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

TEST_CASE("options that are not stated are pbrt-v3's") {
    const Frame frame = good_frame("WorldBegin WorldEnd");
    CHECK(frame.camera.type->name == "perspective");
    CHECK(frame.sampler.type->name == "halton");
    CHECK(frame.film.type->name == "image");
    CHECK(frame.filter.type->name == "box");
    CHECK(frame.integrator.type->name == "path");
    CHECK(frame.accelerator.type->name == "bvh");
    CHECK(frame.camera.where.line == 0);
    CHECK(frame.transform_times == std::array{0.0, 1.0});
}

TEST_CASE("every option is stated by a statement of its own") {
    const Frame frame = good_frame(
        "Camera \"orthographic\" Sampler \"lowdiscrepancy\" Film \"image\" \"integer xresolution\" "
        "7\n"
        "PixelFilter \"mitchell\" Integrator \"volpath\" Accelerator \"kdtree\" WorldBegin "
        "WorldEnd");
    CHECK(frame.camera.type->name == "orthographic");
    CHECK(frame.sampler.type->name == "02sequence");
    CHECK(frame.film.parameters.integer("xresolution") == 7);
    CHECK(frame.filter.type->name == "mitchell");
    CHECK(frame.integrator.type->name == "volpath");
    CHECK(frame.accelerator.type->name == "kdtree");
    CHECK(frame.filter.where.line == 2);
    CHECK(frame.filter.where.column == 1);
}

TEST_CASE("the last statement of an option wins, with all its parameters") {
    const Frame frame = good_frame(
        "Sampler \"sobol\" \"integer pixelsamples\" 3 Sampler \"halton\" "
        "WorldBegin WorldEnd");
    CHECK(frame.sampler.type->name == "halton");
    CHECK(frame.sampler.parameters.integer("pixelsamples") == 16);
}

TEST_CASE("an unknown option is said, and the default stands in for it") {
    const auto said = [](const std::string& statement) {
        const ParsedFile file = parse_text(statement + " WorldBegin WorldEnd");
        CHECK(file.frames.size() == 1);
        return messages(file);
    };
    CHECK(said("Sampler \"zobol\"") ==
          Messages{"a.pbrt:1:1: error: unknown sampler 'zobol'; 'halton' stands in for it; did you "
                   "mean 'sobol'?"});
    CHECK(said("Camera \"x\"") ==
          Messages{"a.pbrt:1:1: error: unknown camera 'x'; 'perspective' stands in for it; there "
                   "are: perspective orthographic environment realistic"});
    CHECK(said("Film \"x\"") ==
          Messages{
              "a.pbrt:1:1: error: unknown film 'x'; 'image' stands in for it; there are: image"});
    CHECK(said("Integrator \"ao\"") ==
          Messages{"a.pbrt:1:1: error: unknown integrator 'ao'; 'path' stands in for it; there "
                   "are: path volpath directlighting whitted bdpt mlt sppm ambientocclusion"});
    CHECK(said("Accelerator \"x\"") == Messages{"a.pbrt:1:1: warning: unknown accelerator 'x'; "
                                                "'bvh' stands in for it; there are: bvh kdtree"});
}

TEST_CASE("options in the world are left out with their parameters") {
    for (const char* word :
         {"Camera", "Sampler", "Film", "PixelFilter", "Integrator", "Accelerator"}) {
        const Frame frame =
            world_with(std::string(word) + " \"x\" \"float y\" [ 1 2 ] Shape \"sphere\"",
                       std::string("a.pbrt:1:12: error: '") + word +
                           "' is left out: it belongs before WorldBegin");
        CHECK(frame.shapes.size() == 1);
    }
    world_with("TransformTimes 1 2",
               "a.pbrt:1:12: error: 'TransformTimes' is left out: it belongs before WorldBegin");
    world_with("WorldBegin",
               "a.pbrt:1:12: error: 'WorldBegin' is left out: the world has begun already");
}

TEST_CASE("statements of the world before it are left out") {
    for (const char* statement :
         {"AttributeBegin", "AttributeEnd", "TransformBegin", "TransformEnd", "ReverseOrientation",
          "Material \"matte\"", "MakeNamedMaterial \"a\" \"string type\" \"matte\"",
          "NamedMaterial \"a\"", "Texture \"a\" \"float\" \"constant\"", "Shape \"sphere\"",
          "LightSource \"point\"", "AreaLightSource \"diffuse\"", "ObjectBegin \"a\"", "ObjectEnd",
          "ObjectInstance \"a\"", "WorldEnd"}) {
        const std::string text = statement;
        const ParsedFile file = parse_text(text + " WorldBegin WorldEnd");
        CHECK(messages(file) == Messages{"a.pbrt:1:1: error: '" + text.substr(0, text.find(' ')) +
                                         "' is left out: it belongs after WorldBegin"});
        REQUIRE(file.frames.size() == 1);
        CHECK(file.frames[0].shapes.empty());
    }
}

TEST_CASE("several frames may follow each other, each from the beginning") {
    const ParsedFile file = parse_text(
        "Translate 1 0 0 Camera \"orthographic\" CoordinateSystem \"s\" TransformTimes 3 4\n"
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" WorldBegin\n"
        "Material \"glass\" ReverseOrientation ObjectBegin \"o\" ObjectEnd\n"
        "Texture \"t\" \"float\" \"constant\" MakeNamedMaterial \"n\" \"string type\" \"matte\"\n"
        "WorldEnd\n"
        "WorldBegin Shape \"sphere\" WorldEnd");
    CHECK(messages(file) == Messages{});
    REQUIRE(file.frames.size() == 2);
    const Frame& second = file.frames[1];
    CHECK(second.camera.type->name == "perspective");
    CHECK(second.camera_transforms[0].to_world == Matrix4{});
    CHECK(second.transform_times == std::array{0.0, 1.0});
    CHECK(second.media.empty());
    CHECK(second.materials.at(second.shapes.at(0).material).plugin.type->name == "matte");
    CHECK_FALSE(second.shapes.at(0).reverse_orientation);
}

TEST_CASE("names of one frame are unknown in the next") {
    const std::string first =
        "WorldBegin CoordinateSystem \"a\" MakeNamedMaterial \"a\" \"string type\" \"matte\" "
        "Texture \"a\" \"float\" \"constant\" ObjectBegin \"a\" Shape \"sphere\" ObjectEnd "
        "MakeNamedMedium \"a\" \"string type\" \"homogeneous\" WorldEnd\nWorldBegin ";
    for (const char* use : {"CoordSysTransform \"a\"", "NamedMaterial \"a\"",
                            "Material \"matte\" \"texture sigma\" \"a\"", "ObjectInstance \"a\"",
                            "MediumInterface \"a\" Shape \"sphere\" MediumInterface \"\""}) {
        const ParsedFile file = parse_text(first + use + " WorldEnd");
        CAPTURE(use, messages(file));
        REQUIRE_FALSE(file.diagnostics.empty());
        CHECK(file.diagnostics[0].kind == "undefined");
        CHECK(file.diagnostics[0].line == 2);
    }
}
