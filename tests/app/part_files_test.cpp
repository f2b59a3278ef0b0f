// Forged sums after an image: their hash is valid, but nothing else needs to be.
#include "app/merge/merged_films.h"
#include "core/base/hash64.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;

namespace {

using Json = nlohmann::ordered_json;

/// An appendix of an image of 4 x 3 pixels.
FilmAppendix good_appendix() {
    const Json identity = {{"resolution", {4, 3}},
                           {"crop", {0, 0, 4, 3}},
                           {"filter", Json::array({"box", {0.5, 0.5}})},
                           {"display values", {false, false}}};
    return {identity, Json::object(), {{{{0, 0}, {3, 2}}, {{0, 0, 1}}, 0}}};
}

/// The bytes of a film without samples.
std::string film_bytes(ImageFilm film) {
    std::string bytes;
    StateWriter writer([&](std::string_view piece) { bytes += piece; });
    film.transfer(writer);
    return bytes;
}

std::string error_of(FilmAppendix appendix, const std::string& film) {
    const test::TemporaryFolder folder;
    const std::string path = folder / "part.exr";
    for (StoredFilm& stored : appendix.films) {
        if (stored.bytes == 0) stored.bytes = film.size();
    }
    test::put(path, film_appendix(appendix, film));
    const Result<MergedFilms> merged = merge_films({path});
    return merged ? "" : merged.error.substr(path.size());
}

}  // namespace

TEST_CASE("What no image could have left behind is refused, though its hash fits", "[app]") {
    const std::string film = film_bytes(ImageFilm({{0, 0}, {3, 2}}, RenderSettings{}));
    const std::string damaged = ": the sums behind the image are damaged";
    REQUIRE(error_of(good_appendix(), film) == "");

    const auto changed = [&](auto change) {
        FilmAppendix appendix = good_appendix();
        change(appendix);
        return error_of(appendix, film);
    };
    CHECK(changed([](FilmAppendix& a) { a.films.clear(); }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.identity = 1; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.identity.erase("crop"); }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.identity["resolution"] = "large"; }) == damaged);
    CHECK(changed([](FilmAppendix& a) {
              a.identity["filter"] = Json::array({"mitchell", {1e9, 1}});
          }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata["matrix"] = std::vector<std::string>(16); }) ==
          damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].window.max = {100000, 100000}; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].window.max = {-5, 2}; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].bytes = std::uint64_t{1} << 60; }) == damaged);
}

TEST_CASE("A film whose arrays are not of one size is refused", "[app]") {
    Film film({{0, 0}, {3, 2}});
    std::string bytes;
    StateWriter writer([&](std::string_view piece) { bytes += piece; });
    film.transfer(writer);
    writer(SampleRates());
    bytes.resize(bytes.size() - 2 * sizeof(std::uint64_t));  // without errors and rates
    writer(std::vector<Vec3>(2));
    writer(SampleRates());
    CHECK(error_of(good_appendix(), bytes) == ": the sums behind the image are damaged");
}
