#include "core/color/spectrum.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

/// Returns the camera parameters that are read from this text.
Parameters camera(const std::string& parameters) {
    return good_frame("Camera \"perspective\" " + parameters + "\nWorldBegin WorldEnd")
        .camera.parameters;
}

/// The same with one message.
Parameters camera_with(const std::string& parameters, const std::string& message) {
    ParsedFile file = parse_text("Camera \"perspective\" " + parameters + "\nWorldBegin WorldEnd");
    CAPTURE(parameters);
    CHECK(messages(file) == Messages{message});
    CHECK_FALSE(file.is_fatal);
    REQUIRE(file.frames.size() == 1);
    return file.frames.front().camera.parameters;
}

Parameters light_with(const std::string& parameters, const std::string& message) {
    return world_with("LightSource \"point\" " + parameters, message)
        .lights.at(0)
        .plugin.parameters;
}

Color light_color(const std::string& parameters) {
    return good_world("LightSource \"point\" " + parameters)
        .lights.at(0)
        .plugin.parameters.color("I");
}

}  // namespace

TEST_CASE("one value stands with or without brackets") {
    CHECK(camera("\"float fov\" 30").number("fov") == 30);
    CHECK(camera("\"float fov\" [ 30 ]").number("fov") == 30);
    CHECK(camera("\"float fov\"[30]").number("fov") == 30);
    CHECK(camera("  \"  float\tfov  ignored\" 30").number("fov") == 30);
}

TEST_CASE("a parameter that is not given has its default") {
    const Parameters p = camera("\"float fov\" 30");
    CHECK(p.is_given("fov"));
    CHECK_FALSE(p.is_given("lensradius"));
    CHECK(p.number("focaldistance") == 1e6F);
    CHECK(p.numbers("screenwindow").empty());
}

TEST_CASE("numbers are floats") {
    CHECK(camera("\"float fov\" 0.1").number("fov") == 0.1F);
}

TEST_CASE("integers are read as doubles and truncated") {
    const auto samples = [](const std::string& value) {
        return good_frame("Sampler \"halton\" \"integer pixelsamples\" " + value +
                          " WorldBegin WorldEnd")
            .sampler.parameters.integer("pixelsamples");
    };
    CHECK(samples("7") == 7);
    CHECK(samples("7.9") == 7);
    CHECK(samples("[ -7.9 ]") == -7);
    CHECK(samples("1e3") == 1000);
    CHECK(samples("16777217") == 16777217);
}

TEST_CASE("a flag is a quoted word, and false if it is neither") {
    const auto center = [](const std::string& value) {
        return parse_text("Sampler \"halton\" \"bool samplepixelcenter\" " + value +
                          " WorldBegin WorldEnd");
    };
    CHECK(center("\"true\"").frames[0].sampler.parameters.flag("samplepixelcenter"));
    CHECK_FALSE(center("[ \"false\" ]").frames[0].sampler.parameters.flag("samplepixelcenter"));
    const ParsedFile other = center("\"yes\"");
    CHECK_FALSE(other.frames[0].sampler.parameters.flag("samplepixelcenter"));
    CHECK(messages(other) ==
          Messages{"a.pbrt:1:18: warning: 'samplepixelcenter' is true or false; 'yes' is taken for "
                   "false"});
}

TEST_CASE("trailing characters of a number are dropped with a warning") {
    CHECK(camera_with("\"float fov\" 30abc",
                      "a.pbrt:1:34: warning: '30abc' is read as '30': the rest is ignored")
              .number("fov") == 30);
}

TEST_CASE("surplus numbers of a type are dropped with a warning") {
    const Parameters p = light_with(
        "\"rgb I\" [1 2 3 4]",
        "a.pbrt:1:32: warning: 'I' takes 3 numbers per value, found 4; left out at the end: 1");
    CHECK(p.color("I") == Color(1, 2, 3));
}

TEST_CASE("an unknown type, or none, loses the parameter") {
    const std::string types =
        "types are: integer, float, bool, point2, vector2, point, vector, normal, string, texture, "
        "rgb, color, xyz, blackbody, spectrum";
    CHECK(camera_with("\"double fov\" 30",
                      "a.pbrt:1:22: error: expected a type and a name, found "
                      "'double fov'; " +
                          types)
              .number("fov") == 90);
    CHECK(camera_with("\"float\" 30",
                      "a.pbrt:1:22: error: expected a type and a name, found 'float'; " + types)
              .number("fov") == 90);
    CHECK(
        camera_with("\"\" 30", "a.pbrt:1:22: error: expected a type and a name, found ''; " + types)
            .number("fov") == 90);
}

TEST_CASE("of a parameter given twice the later value counts") {
    CHECK(camera_with("\"float fov\" 30 \"float fov\" 40",
                      "a.pbrt:1:37: warning: 'fov' of 'Camera' is given again; the later value "
                      "counts")
              .number("fov") == 40);
}

TEST_CASE("an unknown parameter is not used") {
    camera_with("\"float fow\" 30",
                "a.pbrt:1:22: warning: 'fow' is not used: the camera "
                "'perspective' has no such parameter; did you mean 'fov'?");
}

TEST_CASE("a parameter of another type is not used") {
    CHECK(camera_with("\"integer fov\" 30",
                      "a.pbrt:1:22: warning: 'integer fov' is not used: in "
                      "the camera 'perspective' its type is float")
              .number("fov") == 90);
}

TEST_CASE("a parameter is not used beside another value of it") {
    const auto said = [](const std::string& world) { return messages(parse_world(world)); };
    const std::string texture = "Texture \"a\" \"spectrum\" \"constant\"\n";
    CHECK(said(texture + "Material \"matte\" \"texture Kd\" \"a\" \"rgb Kd\" [1 1 1]") ==
          Messages{"a.pbrt:2:35: warning: 'rgb Kd' is not used beside another value of 'Kd'"});
    CHECK(said("LightSource \"infinite\" \"integer nsamples\" 2 \"integer samples\" 3") ==
          Messages{"a.pbrt:1:35: warning: 'integer nsamples' is not used beside another value of "
                   "'samples'"});
}

TEST_CASE("a parameter of one value is not used with another number of them") {
    CHECK(camera_with("\"float fov\" [30 40]",
                      "a.pbrt:1:22: warning: 'fov' is not used: it takes one value, not 2")
              .number("fov") == 90);
    CHECK(camera_with("\"float fov\" []",
                      "a.pbrt:1:22: warning: 'fov' is not used: it takes one value, not 0")
              .number("fov") == 90);
}

TEST_CASE("a list of four is not used with another number of values") {
    CHECK(camera("\"float screenwindow\" [-1 2 -3 4]").numbers("screenwindow")[3] == 4);
    CHECK(camera_with("\"float screenwindow\" [1 2 3]",
                      "a.pbrt:1:22: error: 'screenwindow' is not used: it takes 4 values, not 3")
              .numbers("screenwindow")
              .empty());
}

TEST_CASE("strings for a number, and numbers for a string, lose the parameter") {
    camera_with("\"float fov\" \"30\"",
                "a.pbrt:1:22: error: 'fov' has the type float and takes numbers, "
                "not strings; it is left out");
    camera_with("\"string fov\" 30",
                "a.pbrt:1:22: error: 'fov' has the type string and takes strings, not "
                "numbers; it is left out");
    camera_with("\"texture fov\" [ \"a\" \"b\" ]",
                "a.pbrt:1:22: error: 'fov' takes the name of "
                "one texture, not 2; it is left out");
}

TEST_CASE("a number that is not finite loses the parameter and says its place") {
    for (const char* number : {"nan", "inf", "-Infinity", "1e400", "1e39"}) {
        CAPTURE(number);
        CHECK(camera_with(std::string("\"float fov\" ") + number,
                          "a.pbrt:1:34: error: a number of 'fov' is not finite, or too large; the "
                          "parameter is left out")
                  .number("fov") == 90);
    }
    const ParsedFile file =
        parse_text("Sampler \"halton\"\n\"integer pixelsamples\" 3e9 WorldBegin WorldEnd");
    CHECK(messages(file) == Messages{"a.pbrt:2:24: error: a number of 'pixelsamples' is not "
                                     "finite, or too large; the parameter is left out"});
    CHECK(file.frames[0].sampler.parameters.integer("pixelsamples") == 16);
}

TEST_CASE("a parameter whose default is infinite may be infinite") {
    const Frame frame =
        good_frame("Film \"image\" \"float maxsampleluminance\" inf WorldBegin WorldEnd");
    CHECK(std::isinf(frame.film.parameters.number("maxsampleluminance")));
    CHECK(frame.film.parameters.is_given("maxsampleluminance"));
}

TEST_CASE("an unknown choice is an error and the default is kept") {
    const ParsedFile file = parse_text(
        "Integrator \"path\" \"string lightsamplestrategy\" \"photontree\" WorldBegin WorldEnd");
    CHECK(messages(file) ==
          Messages{"a.pbrt:1:19: error: unknown 'lightsamplestrategy' 'photontree'; it is "
                   "'spatial' instead; there are: spatial uniform power"});
    CHECK(file.frames[0].integrator.parameters.string("lightsamplestrategy") == "spatial");
}

TEST_CASE("rgb and color are the same") {
    CHECK(light_color("\"rgb I\" [1 2 3]") == Color(1, 2, 3));
    CHECK(light_color("\"color I\" [1 2 3]") == Color(1, 2, 3));
}

TEST_CASE("xyz, blackbody and spectra are converted to RGB") {
    CHECK(light_color("\"xyz I\" [1 2 3]") == xyz_color({1, 2, 3}));
    CHECK(light_color("\"blackbody I\" [3000 1.5]") == blackbody_color(3000) * 1.5F);
    CHECK(light_color("\"spectrum I\" [400 1 700 2]") ==
          spectrum_color(std::vector<SpectralSample>{{400, 1}, {700, 2}}));
}

TEST_CASE("two black bodies are two values, a spectrum of many pairs is one") {
    light_with("\"blackbody I\" [3000 1 4000 1]",
               "a.pbrt:1:32: warning: 'I' is not used: it takes one value, not 2");
    light_with(
        "\"blackbody I\" [3000 1 4000]",
        "a.pbrt:1:32: warning: 'I' takes 2 numbers per value, found 3; left out at the end: 1");
    light_with(
        "\"spectrum I\" [400 1 500]",
        "a.pbrt:1:32: warning: 'I' takes 2 numbers per value, found 3; left out at the end: 1");
}

TEST_CASE("a spectrum in a file that is missing is black") {
    const Parameters p = light_with("\"spectrum I\" \"none.spd\"",
                                    "a.pbrt:1:32: warning: the spectrum 'none.spd' cannot be "
                                    "opened: No such file or directory; it is black");
    CHECK(p.color("I") == Color(0.0F));
}

TEST_CASE("another name of a parameter is used where the first is not given") {
    const auto sppm = [](const std::string& parameters) {
        return parse_text("Integrator \"sppm\" " + parameters + " WorldBegin WorldEnd")
            .frames.at(0)
            .integrator.parameters.integer("iterations");
    };
    CHECK(sppm("\"integer iterations\" 3") == 3);
    CHECK(sppm("\"integer numiterations\" 4") == 4);
    CHECK(sppm("\"integer numiterations\" 4 \"integer iterations\" 3") == 3);
}

TEST_CASE("a strict reader has errors in place of warnings") {
    const ParsedFile file =
        parse_text("Camera \"perspective\" \"float fow\" 30 WorldBegin WorldEnd",
                   {.strict = true, .root = {}});
    REQUIRE(file.diagnostics.size() == 1);
    CHECK(file.diagnostics[0].severity == Severity::error);
    CHECK_FALSE(file.is_fatal);
}

TEST_CASE("a file's name is its path from the directory of the scene") {
    const auto path_of = [](const std::string& scene, const std::string& name) {
        const ParsedFile file = parse(
            "WorldBegin Shape \"plymesh\" \"string filename\" \"" + name + "\" WorldEnd", scene);
        return std::string(file.frames.at(0).shapes.at(0).plugin.parameters.string("filename"));
    };
    CHECK(path_of("a.pbrt", "m.ply") == "m.ply");
    CHECK(path_of("x/a.pbrt", "y/m.ply") == "x/y/m.ply");
    CHECK(path_of("x/a.pbrt", "../m.ply") == "m.ply");
    CHECK(path_of("x/a.pbrt", "/m.ply") == "/m.ply");
    CHECK(path_of("-", "m.ply") == "m.ply");
}
