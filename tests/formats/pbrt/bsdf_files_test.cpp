// Files of tabulated BSDFs, and messages about invalid ones.
#include "core/formats/load.h"
#include "core/formats/pbrt/build/bsdf_file.h"
#include "tests/catch.h"
#include "tests/fourier_tables.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using pbrt::parse_bsdf_file;

namespace {

const FourierTable& small_table() {
    static const FourierTable table = table_of(cosines_of_table(3), 4, glossy_both_sides);
    return table;
}

/// Returns the file with a word of 32 bits replaced; the words of the header start at number 2.
template <class Word>
std::string with_word(std::size_t number, Word word) {
    std::string bytes = bytes_of(small_table());
    std::memcpy(bytes.data() + 4 * number, &word, 4);
    return bytes;
}

std::string error_of(const std::string& bytes) {
    return parse_bsdf_file(bytes).error;
}

constexpr std::size_t words_of_header = 16;

}  // namespace

TEST_CASE("A file of a table is read") {
    const FourierTable& table = small_table();
    const Result<FourierTable> read = parse_bsdf_file(bytes_of(table) + "metadata");
    CHECK(read.error.empty());
    CHECK(read.value.cosines == table.cosines);
    CHECK(read.value.sums == table.sums);
    CHECK(read.value.coefficients == table.coefficients);
    CHECK(read.value.channels == 3);
    CHECK(read.value.series.back().first == table.series.back().first);
}

TEST_CASE("Files that are no table say why") {
    const auto infinite = std::numeric_limits<float>::infinity();
    CHECK(error_of("") == "does not begin as a table of a BSDF, with SCATFUN and 1");
    CHECK(error_of("SCATFUN\x02") == error_of(""));
    CHECK(error_of("SCATFUN\x01 ") == "ends within its header");
    CHECK(error_of(with_word(2, 3)) == "has the flags 3: expected 1, a plain BSDF");
    CHECK(error_of(with_word(3, 1)) == "announces 1 cosines and 252 coefficients");
    CHECK(error_of(with_word(4, -1)) == "announces 6 cosines and -1 coefficients");
    CHECK(error_of(with_word(3, 10000)).starts_with("ends early: "));
    CHECK(error_of(with_word(6, 2)) == "has 2 channels: expected 1 or 3");
    CHECK(error_of(with_word(7, 0)) == "has 0 bases: expected 1, without textures");
    CHECK(error_of(with_word(11, 0.0F)) == "has an index of refraction that is not positive");
    CHECK(error_of(with_word(words_of_header, -1.5F)) ==
          "has cosines that do not increase from -1 to 1");
    CHECK(error_of(with_word(words_of_header + 1, -1.0F)) == error_of(with_word(16, -1.5F)));
    CHECK(error_of(with_word(words_of_header + 8, infinite)) == "has a number that is not finite");
    const std::size_t first_series = words_of_header + 6 + 36;
    CHECK(error_of(with_word(first_series, 330)) ==
          "has a series beyond the end of its coefficients");
    CHECK(error_of(with_word(first_series + 1, -1)) == error_of(with_word(first_series, 330)));
}

TEST_CASE("A file of a table that ends anywhere is an error") {
    const std::string bytes = bytes_of(small_table());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        CAPTURE(size);
        CHECK_FALSE(parse_bsdf_file(std::string_view(bytes).substr(0, size)));
    }
}

TEST_CASE("A table that cannot be read is named where the material is, and its surface is black") {
    const TemporaryFolder folder;
    put(folder / "a.bsdf", bytes_of(small_table()));
    put(folder / "bad.bsdf", "SCATFUN\x01");
    const auto said_of = [&](const std::string& parameters) {
        const LoadResult r = load_scene_text(
            "WorldBegin\nMaterial \"fourier\" " + parameters + "\nShape \"sphere\"\nWorldEnd\n",
            folder / "scene.pbrt");
        REQUIRE(r.scene);
        const auto& built = r.scene->physical().materials.back().kind;
        const bool has_table = std::get<FourierMaterial>(built).table != nullptr;
        CHECK(has_table == r.diagnostics.empty());
        return r.diagnostics.empty() ? "" : to_string(r.diagnostics[0]);
    };
    const std::string scene = folder / "scene.pbrt";
    CHECK(said_of("\"string bsdffile\" \"a.bsdf\"").empty());
    CHECK(said_of("") == scene + ":2:1: warning: no bsdffile is given; the surface is black");
    CHECK(said_of("\"string bsdffile\" \"bad.bsdf\"") ==
          scene + ":2:1: warning: '" + (folder / "bad.bsdf") +
              "' ends within its header; the surface is black");
    CHECK(said_of("\"string bsdffile\" \"none.bsdf\"").starts_with(scene + ":2:1: warning: '"));
}
