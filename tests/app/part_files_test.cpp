// Forged sums after an image: their hash is valid, but nothing else needs to be.
#include "app/common/shallow_json.h"
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

std::string film_appendix(const FilmAppendix& appendix, const std::string& films) {
    std::string result;
    write_appendix(
        appendix_line(appendix), [&](std::string_view bytes) { result += bytes; },
        [&](const StateWriter::Sink& put) { put(films); });
    return result;
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
    for (const Json& width : {Json(4 + (std::int64_t{1} << 32)), Json(4.5), Json(1e57)}) {
        const auto resized = [&](FilmAppendix& a) { a.identity["resolution"][0] = width; };
        CHECK(changed(resized) == damaged);
    }
    CHECK(changed([](FilmAppendix& a) {
              a.identity["filter"] = Json::array({"mitchell", {1e9, 1}});
          }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata["matrix"] = std::vector<std::string>(16); }) ==
          damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata = Json::array(); }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata["channels"] = "R"; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata["compression"] = 1; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.metadata[""] = "?"; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].window.max = {100000, 100000}; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].window.max = {-5, 2}; }) == damaged);
    CHECK(changed([](FilmAppendix& a) { a.films[0].bytes = std::uint64_t{1} << 60; }) == damaged);
}

TEST_CASE("A film takes no more bytes in memory than a few times those in the file", "[app]") {
    RenderSettings settings;
    settings.filter.kind = FilterKind::gaussian;
    for (const double radius : {1.0, 2.5, max_filter_radius}) {
        settings.filter.radius = {radius, 1.5};
        const Imath::Box2i window{{13, 2}, {40, 31}};
        const std::size_t bytes = film_bytes(ImageFilm(window, settings)).size();
        const std::uint64_t least = ImageFilm::least_bytes(window, settings);
        CHECK(least <= bytes);
        CHECK(least > bytes - 100);  // the lengths of arrays
    }
    const test::TemporaryFolder folder;
    FilmAppendix wide = good_appendix();
    wide.identity["filter"] = Json::array({"gaussian", {max_filter_radius, max_filter_radius}, 2});
    const std::string film(std::size_t{1000}, '\0');
    wide.films[0].bytes = film.size();
    test::put(folder / "part.exr", film_appendix(wide, film));
    CHECK_THAT(AppendixReader().open(folder / "part.exr").error,
               ContainsSubstring("the sums behind the image are damaged"));
}

TEST_CASE("Shares that continue each other become one, and many can be read again", "[app]") {
    std::vector<SampleShare> shares = {{1, 0, 2}, {0, 4, 6}, {0, 2, 4}, {0, 7, 9}};
    join_shares(shares);
    CHECK(shares == std::vector<SampleShare>{{0, 2, 6}, {0, 7, 9}, {1, 0, 2}});
    shares = {{0, 0, 2, false}, {0, 2, 4, true}};
    join_shares(shares);
    CHECK(shares.size() == 2);

    FilmAppendix appendix = good_appendix();
    for (std::uint32_t i = 1; i < 100000; ++i)
        appendix.films[0].shares.push_back({0, 2 * i, 2 * i + 1});
    REQUIRE(appendix_line(appendix).size() > 1 << 20);
    CHECK(error_of(appendix, film_bytes(ImageFilm({{0, 0}, {3, 2}}, RenderSettings{}))) == "");
}

TEST_CASE("A reason to stop that is no text is none", "[app]") {
    FilmAppendix appendix = good_appendix();
    appendix.metadata["stopped"] = 7;
    CHECK(error_of(appendix, film_bytes(ImageFilm({{0, 0}, {3, 2}}, RenderSettings{}))) == "");
}

TEST_CASE("JSON in a file is not deeper than the stack", "[app]") {
    constexpr int depth = 400000;
    const std::string deep = std::string(depth, '[') + std::string(depth, ']');
    const Json json = parse_shallow_json(R"({"a": {"b": [1, [2]]}, "deep": )" + deep + "}");
    CHECK(json["a"].dump() == R"({"b":[1,[2]]})");
    CHECK(json["deep"].dump().size() < 20);
    CHECK(parse_shallow_json("{").is_discarded());
}

TEST_CASE("A film whose counts or rates are not of its pixels is refused", "[app]") {
    const auto identity_with = [](const char* filter, double radius) {
        FilmAppendix appendix = good_appendix();
        appendix.identity["filter"] = Json::array({filter, {radius, radius}});
        return appendix;
    };
    const std::string damaged = ": the sums behind the image are damaged";
    RenderSettings settings;
    settings.filter.kind = FilterKind::triangle;
    settings.filter.radius = {2, 2};
    std::string film = film_bytes(ImageFilm({{0, 0}, {3, 2}}, settings));
    REQUIRE(error_of(identity_with("triangle", 2), film) == "");
    const auto end_of = [&](const auto& values) {
        std::string bytes;
        StateWriter([&](std::string_view piece) { bytes += piece; })(values);
        return bytes;
    };
    film.resize(film.size() - sizeof(std::uint64_t));  // without the samples of cells
    CHECK(error_of(identity_with("triangle", 2), film + end_of(std::vector<double>(7))) == damaged);

    std::string plain = film_bytes(ImageFilm({{0, 0}, {3, 2}}, RenderSettings{}));
    plain.resize(plain.size() - sizeof(std::uint64_t));  // without the rates
    CHECK(error_of(good_appendix(), plain + end_of(SampleRates(12, 1))) == "");
    CHECK(error_of(good_appendix(), plain + end_of(SampleRates(12, 0))) == damaged);
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
