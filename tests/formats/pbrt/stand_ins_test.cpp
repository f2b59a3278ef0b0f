// Warnings about statements that are not rendered as given, and their positions.
#include "core/formats/load.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;

namespace {

const std::string triangle =
    "Shape \"trianglemesh\" \"point P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]";

/// Returns the messages about a scene with this world, after its first line.
std::vector<std::string> said_of_world(const std::string& world, const LoadOptions& options = {}) {
    const LoadResult r =
        load_scene_text("WorldBegin\n" + world + "\nWorldEnd\n", "a.pbrt", options);
    CHECK(r.scene.has_value() != options.strict);
    std::vector<std::string> list;
    for (const Diagnostic& d : r.diagnostics) list.push_back(to_string(d));
    return list;
}

/// Returns a chain of textures in which each uses the previous one twice.
std::string nested_textures(int depth) {
    std::string text = "Texture \"t0\" \"spectrum\" \"constant\"\n";
    for (int i = 1; i < depth; ++i) {
        const std::string before = "\"t" + std::to_string(i - 1) + "\"";
        text += "Texture \"t" + std::to_string(i) + "\" \"spectrum\" \"scale\" \"texture tex1\" " +
                before + " \"texture tex2\" " + before + "\n";
    }
    return text;
}

using Said = std::vector<std::string>;

}  // namespace

TEST_CASE("textures are nested until one value takes more than a thousand of them") {
    CHECK(said_of_world(nested_textures(9)) == Said{});
    CHECK(
        said_of_world(nested_textures(10)) ==
        Said{"a.pbrt:11:1: warning: more than 1000 textures are nested in this one; the constant 1 "
             "stands in for it"});
    CHECK(said_of_world(nested_textures(40)).size() == 4);  // the count is reset each time
}

TEST_CASE("Checkerboard: given dimensions other than two and three, then there are two of them") {
    const auto said = [](const std::string& dimension) {
        return said_of_world("Texture \"t\" \"spectrum\" \"checkerboard\" \"integer dimension\" " +
                             dimension + "\nMaterial \"matte\" \"texture Kd\" \"t\"\n" + triangle);
    };
    CHECK(said("2").empty());
    CHECK(said("3").empty());
    CHECK(said("5") == Said{"a.pbrt:2:1: warning: a checkerboard of dimension 5: expected 2 or 3; "
                            "taken as 2"});
}

TEST_CASE("a camera that shows no area causes a warning") {
    for (const char* camera :
         {"\"perspective\" \"float fov\" 0", "\"orthographic\" \"float screenwindow\" [1 1 -1 1]",
          "\"perspective\" \"float frameaspectratio\" 0"}) {
        CAPTURE(camera);
        const LoadResult r = load_scene_text(
            std::string("Camera ") + camera + "\nWorldBegin Shape \"sphere\" WorldEnd\n", "a.pbrt");
        REQUIRE(r.scene);
        REQUIRE(r.diagnostics.size() == 1);
        CHECK(to_string(r.diagnostics[0]) ==
              "a.pbrt:1:1: warning: the image shows no area; a "
              "window from -1 to 1 stands in");
        CHECK(r.scene->camera.projective->window({200, 100}).width() == 4);
    }
}

TEST_CASE("Pixel filter: given a parameter that leaves no weights, then its default stands in") {
    const auto filter_of = [](const std::string& filter, const std::string& problem) {
        CAPTURE(filter);
        const LoadResult r = load_scene_text(
            "PixelFilter " + filter + "\nWorldBegin Shape \"sphere\" WorldEnd\n", "a.pbrt");
        REQUIRE(r.diagnostics.size() == 1);
        CHECK(to_string(r.diagnostics[0]) == "a.pbrt:1:1: warning: " + problem);
        return r.settings.filter;
    };
    for (const std::string alpha : {"0", "-1"}) {
        CHECK(filter_of("\"gaussian\" \"float alpha\" " + alpha,
                        "alpha " + alpha + ": expected a number above 0; taken as 2")
                  .alpha == 2);
    }
    CHECK(
        filter_of("\"sinc\" \"float tau\" 0", "tau 0: expected a number above 0; taken as 3").tau ==
        3);
}

TEST_CASE("a mix whose materials may have more lobes than fit causes a warning") {
    std::string world;
    for (const char* name : {"a", "b", "c"}) {
        world += "MakeNamedMaterial \"" + std::string(name) +
                 "\" \"string type\" \"uber\" \"float index\" 1.5 \"rgb Kd\" [0 0 ." +
                 std::to_string(name[0]) + "]\n";
    }
    const auto mix = [](const std::string& name, const std::string& a, const std::string& b) {
        return "MakeNamedMaterial \"" + name +
               "\" \"string type\" \"mix\" \"string namedmaterial1\" \"" + a +
               "\" \"string namedmaterial2\" \"" + b + "\"\n";
    };
    const std::string sphere = "Shape \"sphere\"";
    const std::string two = world + mix("ab", "a", "b");
    CHECK(said_of_world(two + "NamedMaterial \"ab\" " + sphere) == Said{});
    const Said said =
        said_of_world(two + mix("all", "ab", "c") + "NamedMaterial \"all\" " + sphere);
    REQUIRE(said.size() == 1);
    CHECK(
        said[0].ends_with("warning: the materials of this mix have up to 15 lobes; those after "
                          "the first 12 are left out"));
}

TEST_CASE("an integrator that ignores media causes a warning at its statement") {
    const std::string medium = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"";
    CHECK(said_of_world(medium) == Said{});
    CHECK(said_of_world(medium + " MediumInterface \"m\"") ==
          Said{"a.pbrt: warning: integrator \"path\" leaves out media, as in pbrt-v3; \"volpath\" "
               "renders them"});
}

TEST_CASE("the integrator chosen instead of the file's causes the warning of ignored media") {
    const auto said = [](const std::string& integrator, const std::string& chosen) {
        LoadOptions options;
        options.integrator = chosen;
        const LoadResult r = load_scene_text("Integrator \"" + integrator +
                                                 "\" WorldBegin\n"
                                                 "MakeNamedMedium \"m\" \"string type\" "
                                                 "\"homogeneous\" MediumInterface \"m\" WorldEnd\n",
                                             "a.pbrt", options);
        return report(r.diagnostics);
    };
    for (const char* integrator : {"path", "volpath", "bdpt", "ambientocclusion"}) {
        CAPTURE(integrator);
        CHECK(said(integrator, "volpath") == "");
        for (const std::string chosen : {"path", "ao"}) {
            CHECK(said(integrator, chosen) == "a.pbrt:2:1: warning: integrator \"" + chosen +
                                                  "\" leaves out media, as in pbrt-v3; "
                                                  "\"volpath\" renders them\n");
        }
    }
}

TEST_CASE("numbers that no medium can have are replaced, and named") {
    const std::string before = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" ";
    CHECK(said_of_world(before + "\"float g\" 1") ==
          Said{"a.pbrt:2:1: warning: 'g' 1: expected a number between -1 and 1; taken as 0.9999"});
    CHECK(said_of_world(before + "\"rgb sigma_a\" [1 -1 1]") ==
          Said{"a.pbrt:2:1: warning: 'sigma_a' is below 0, where it is taken as 0"});
    CHECK(said_of_world(before + "\"string preset\" \"Skin\"") ==
          Said{"a.pbrt:2:1: warning: unknown preset 'Skin'; it has the defaults; did you mean "
               "'Skin1'?"});
    CHECK(said_of_world("Scale 1 0 1 MakeNamedMedium \"m\" \"string type\" \"heterogeneous\" "
                        "\"float density\" 1")
              .size() == 1);
}

TEST_CASE("a medium has the coefficients of its preset unless it has its own") {
    const LoadResult r = load_scene_text(
        "WorldBegin MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"string preset\" "
        "\"Ketchup\" \"rgb sigma_a\" [1 2 3] \"float scale\" 2 \"float g\" .5 WorldEnd",
        "a.pbrt", {});
    REQUIRE(r.scene);
    REQUIRE(r.scene->physical().media.size() == 1);
    const PhysicalMedium& medium = r.scene->physical().media[0];
    CHECK(medium.absorption == Color(2, 4, 6));
    CHECK(medium.scattering == Color(0.36F, 0.14F, 0.06F));
    CHECK(medium.g == 0.5F);
}

TEST_CASE("tangents of a mesh are said to be left out") {
    CHECK(said_of_world(triangle + " \"vector S\" [1 0 0 1 0 0 1 0 0]") ==
          Said{"a.pbrt:2:1: warning: \"S\" left out: tangents follow the texture coordinates"});
}

TEST_CASE("surfaces seen from one side only are no choice of PBRT scenes") {
    LoadOptions options;
    options.one_sided = true;
    CHECK(said_of_world(triangle, options) ==
          Said{"a.pbrt: warning: --one-sided is not for PBRT scenes: surfaces are seen from both "
               "sides"});
}
