#include "core/formats/nearest_name.h"

#include <array>
#include <string>

#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr std::array<std::string_view, 7> names = {"s",      "pl",    "mat", "mesh",
                                                   "camera", "light", "bclr"};

}  // namespace

TEST_CASE("a mistyped name finds the one that was meant") {
    CHECK(nearest_name("camra", names) == "camera");    // lost
    CHECK(nearest_name("caamera", names) == "camera");  // added
    CHECK(nearest_name("lihgt", names) == "light");     // swapped
    CHECK(nearest_name("lp", names) == "pl");
    CHECK(nearest_name("mech", names) == "mesh");  // exchanged
    CHECK(nearest_name("MAT", names) == "mat");    // case
    CHECK(nearest_name("S", names) == "s");
    CHECK(nearest_name("blcr", names) == "bclr");
}

TEST_CASE("of names as near as each other the one with the same beginning is found") {
    constexpr std::array<std::string_view, 3> alike = {"pp", "sps", "spp"};
    CHECK(nearest_name("sp", alike) == "sps");
    CHECK(nearest_name("spx", alike) == "sps");
    CHECK(nearest_name("ppx", alike) == "pp");
}

TEST_CASE("a name that resembles none finds none") {
    CHECK(nearest_name("x", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name("sphere", names).empty());
    CHECK(nearest_name("torus", names).empty());
    CHECK(nearest_name(std::string(1000, 'm'), names).empty());
}

TEST_CASE("a suggestion is part of a sentence, or nothing") {
    CHECK(did_you_mean("camra", names) == "; did you mean 'camera'?");
    CHECK(did_you_mean("torus", names).empty());
}
