#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

/// Returns the first message about a text.
std::string said(const std::string& text) {
    const ParsedFile file = parse_text(text);
    CAPTURE(text);
    REQUIRE_FALSE(file.diagnostics.empty());
    return to_string(file.diagnostics[0]);
}

}  // namespace

TEST_CASE("a file of version 2 is told that it is") {
    for (const char* word : {"SurfaceIntegrator", "VolumeIntegrator", "Renderer", "Volume"}) {
        const std::string name = word;
        CHECK(said(name + " \"x\" \"float y\" 3 WorldBegin WorldEnd") ==
              "a.pbrt:1:1: error: '" + name + "' is of PBRT version 2; Etalon reads version 3");
        CHECK(parse_text(name + " \"x\" \"float y\" 3 WorldBegin WorldEnd").is_fatal);
    }
}

TEST_CASE("a file of version 4 is told that it is") {
    for (const char* word : {"ColorSpace", "Option", "Attribute", "Import"}) {
        const std::string name = word;
        CHECK(said(name + " \"x\" WorldBegin WorldEnd") ==
              "a.pbrt:1:1: error: '" + name + "' is of PBRT version 4; Etalon reads version 3");
    }
}

TEST_CASE("plugins of other versions and of forks are told what they are") {
    CHECK(
        said("Sampler \"zsobol\" WorldBegin WorldEnd") ==
        "a.pbrt:1:1: error: unknown sampler 'zsobol', which is of PBRT version 4; 'halton' stands "
        "in for it");
    CHECK(
        said("Sampler \"bestcandidate\" WorldBegin WorldEnd") ==
        "a.pbrt:1:1: error: unknown sampler 'bestcandidate', which is of PBRT version 2; 'halton' "
        "stands in for it");
    CHECK(said("Integrator \"pssps\" WorldBegin WorldEnd") ==
          "a.pbrt:1:1: error: unknown integrator 'pssps', which is of a fork of PBRT version 3; "
          "'path' stands in for it");
    CHECK(said("WorldBegin Material \"coateddiffuse\" WorldEnd") ==
          "a.pbrt:1:12: warning: unknown material 'coateddiffuse', which is of PBRT version 4; "
          "'matte' stands in for it");
    CHECK(said("WorldBegin Shape \"bilinearmesh\" WorldEnd") ==
          "a.pbrt:1:12: warning: unknown shape 'bilinearmesh', which is of PBRT version 4; it is "
          "left "
          "out");
}

TEST_CASE("the plugins and the choices that forks add are known to be theirs") {
    for (const auto& [statement, name] :
         std::vector<std::pair<std::string, std::string>>{{"Integrator", "depthmap"},
                                                          {"Integrator", "pssps"},
                                                          {"Integrator", "cv"},
                                                          {"Integrator", "direct"},
                                                          {"Sampler", "neural"},
                                                          {"Film", "cv"}}) {
        const std::string message = said(statement + " \"" + name + "\" WorldBegin WorldEnd");
        CAPTURE(message);
        CHECK(message.find("a fork of PBRT version 3") != std::string::npos);
    }
    CHECK(said("WorldBegin Material \"dual\" WorldEnd").find("a fork of PBRT version 3") !=
          std::string::npos);
}
