// Detection of PBRT by the beginning of a text.
#include "core/formats/load.h"
#include "tests/catch.h"

using namespace etalon;

TEST_CASE("a text that starts with any directive of PBRT is PBRT") {
    for (const char* text :
         {"LookAt 0 0 1 0 0 0 0 1 0", "Scale -1 1 1", "Rotate 90 1 0 0", "Translate 1 2 3",
          "Transform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ]", "Identity", "ReverseOrientation",
          "TransformBegin", "ObjectBegin \"a\"", "Include \"geometry.pbrt\"", "PixelFilter \"box\"",
          "Accelerator \"bvh\"", "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"",
          "MakeNamedMaterial \"m\" \"string type\" \"matte\"", "Texture \"t\" \"float\" \"fbm\"",
          "# a comment\n\nShape \"sphere\"", "NamedMaterial \"m\"", "SurfaceIntegrator \"path\"",
          "Film \"image\" \"rgb x\" [ 1 2 3 ]"}) {
        CAPTURE(text);
        CHECK(format_of(text, "scene") == "pbrt");
    }
}

TEST_CASE("what is more frequent in version 4 does not make a text one of version 4") {
    CHECK(format_of("WorldBegin\nTexture \"checks\" \"spectrum\" \"checkerboard\"\n"
                    "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\nWorldEnd\n",
                    "f") == "pbrt");
}

TEST_CASE("a text of other words is not PBRT") {
    CHECK(format_of("b 0 0 0\nv\nfrom 0 0 5\n", "scene") != "pbrt");
    CHECK(format_of("camera\neye 0 0 5\n", "scene") == "p3f");
    CHECK(format_of("shape transform world material", "scene").empty());
}

TEST_CASE("the extension tells where the text does not") {
    CHECK(format_of("# nothing yet\n", "a.pbrt") == "pbrt");
    CHECK(format_of("# nothing yet\n", "a").empty());
}

TEST_CASE("a text of version 4 is not read as version 3") {
    CHECK(format_of("ColorSpace \"rec2020\" Camera \"perspective\"", "a.pbrt").empty());
    CHECK(format_of("Film \"rgb\" WorldBegin", "a.pbrt").empty());
}
