// What a film with an image's settings makes of samples.
#include "core/render/image_film.h"

#include <limits>
#include <set>

#include "core/render/state.h"
#include "core/sampling/sobol.h"
#include "tests/render/state_bytes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Imath::Box2i image({5, 3}, {44, 22});

RenderSettings filtered_settings() {
    RenderSettings settings;
    settings.filter = {FilterKind::gaussian, {2, 2}};
    return settings;
}

/// A colour for each pixel.
Color color_of(int x, int y) {
    return {static_cast<float>(x * y % 7), static_cast<float>(x), static_cast<float>(y % 2)};
}

/// Adds to each pixel of a film so many samples, times its rate, at its centre: `first` to those of
/// the first cells of each row, `others` to the rest.
void add_even(ImageFilm& film, std::uint32_t first, std::uint32_t others) {
    const Imath::Box2i& window = film.samples().window();
    for (int y = window.min.y; y <= window.max.y; ++y) {
        for (int x = window.min.x; x <= window.max.x; ++x) {
            const std::size_t pixel = film.samples().index(x, y);
            const std::uint32_t count = x < 16 ? first : others;
            const std::uint32_t all = count * (film.rates().empty() ? 1 : film.rates()[pixel]);
            const std::vector<Vec2> places(all, Vec2(x + 0.5, y + 0.5));
            std::vector<Color> colors(all, color_of(x, y));
            film.add(std::array{PixelRun{{x, y}, 0, all}}, places, colors);
        }
    }
}

/// Adds a random sample to each pixel. Brightnesses are very different, so that sums are rounded.
void add_random(ImageFilm& film, std::uint32_t number) {
    const Imath::Box2i& window = film.samples().window();
    const ScrambledSobol points(number), colors(~number);
    std::uint32_t next = 0;
    for (int y = window.min.y; y <= window.max.y; ++y) {
        for (int x = window.min.x; x <= window.max.x; ++x, ++next) {
            const Vec2 c = colors(next) * (next % 3 == 0 ? 1e9 : 1);
            Color color(static_cast<float>(c.x), static_cast<float>(c.y), 1);
            const Vec2 place = Vec2(x, y) + points(next);
            film.add(std::array{PixelRun{{x, y}, 0, 1}}, {&place, 1}, {&color, 1});
        }
    }
}

ImageFilm random_film(std::initializer_list<std::uint32_t> numbers) {
    ImageFilm film(image, filtered_settings());
    for (const std::uint32_t number : numbers) add_random(film, number);
    return film;
}

/// Rates above 1 in some pixels of the first cells.
SampleRates some_rates(const ImageFilm& film) {
    SampleRates rates(film.samples().size(), 1);
    for (int y = 5; y < 12; ++y) {
        for (int x = 7; x < 14; ++x) rates[film.samples().index(x, y)] = 4;
    }
    return rates;
}

std::vector<Vec3> means_of(const ImageFilm& film) {
    const Film filtered = film.filtered();
    std::vector<Vec3> means;
    for (std::size_t i = 0; i < filtered.size(); ++i) means.push_back(filtered.mean(i));
    return means;
}

void check_close(const Film& a, const Film& b) {
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK((a.mean(i) - b.mean(i)).length() <= 1e-12 * b.mean(i).length());
    }
}

}  // namespace

TEST_CASE("A sample that is not finite in one channel counts as black", "[film]") {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    ImageFilm film({{0, 0}, {1, 0}}, {});
    const std::array runs{PixelRun{{0, 0}, 0, 2}, PixelRun{{1, 0}, 2, 3}};
    const std::array<Vec2, 3> places{Vec2(0.5), Vec2(0.5), Vec2(1.5, 0.5)};
    for (const float bad : {infinite, -infinite, std::numeric_limits<float>::quiet_NaN()}) {
        for (std::size_t i = 0; i < 9; ++i) {
            std::array<Color, 3> colors;
            colors.fill(Color(1.0F, -2.0F, 3.0F));
            colors[i / 3][static_cast<int>(i) % 3] = bad;
            CAPTURE(bad, i);
            CHECK(film.add(runs, places, colors) == 1);
            CHECK(colors[i / 3] == Color(0.0F));
            CHECK(colors[(i / 3 + 1) % 3] == Color(1.0F, -2.0F, 3.0F));
        }
    }
}

TEST_CASE("Tiles of a filtered image, or of a crop of it, have no cell in common", "[film]") {
    for (const Imath::Box2i& window : {Imath::Box2i({0, 0}, {70, 40}), {{13, 21}, {90, 50}}}) {
        const ImageFilm film(window, filtered_settings());
        std::set<std::pair<int, int>> cells;
        const auto cell = [](int place) { return (place + 16 * 8) / 16; };
        for (const Imath::Box2i& tile : film.tiles()) {
            CAPTURE(tile.min, tile.max);
            CHECK(cell(tile.min.x) == cell(tile.max.x));
            CHECK(cell(tile.min.y) == cell(tile.max.y));
            CHECK(cells.emplace(cell(tile.min.x), cell(tile.min.y)).second);
        }
    }
}

TEST_CASE("More samples of some pixels, by their rates, count no more in a filtered image",
          "[film][rates]") {
    ImageFilm even(image, filtered_settings()), rated = even;
    rated.set_rates(some_rates(rated));
    add_even(even, 1, 1);
    add_even(rated, 1, 1);
    CHECK(rated.samples().total_count() > even.samples().total_count());
    check_close(rated.filtered(), even.filtered());
}

TEST_CASE("Filtered films with rates add up to the image of each", "[film][rates]") {
    ImageFilm even(image, filtered_settings()), first = even, second = even, sum = even;
    add_even(even, 1, 1);
    for (ImageFilm* film : {&first, &second, &sum}) film->set_rates(some_rates(*film));
    add_even(first, 1, 4);
    add_even(second, 3, 1);
    sum.add(first);
    sum.add(second);
    check_close(sum.filtered(), even.filtered());
}

TEST_CASE("Filtered films add up to the same bits in any order", "[film]") {
    const ImageFilm films[] = {random_film({1}), random_film({2, 3}), random_film({4})};
    const auto sum_of = [](std::initializer_list<const ImageFilm*> parts) {
        ImageFilm sum(image, filtered_settings());
        for (const ImageFilm* part : parts) sum.add(*part);
        return sum;
    };
    const ImageFilm first_two = sum_of({&films[0], &films[1]});
    const ImageFilm sum = sum_of({&films[0], &films[1], &films[2]});
    CHECK(means_of(sum_of({&films[2], &films[1], &films[0]})) == means_of(sum));
    CHECK(means_of(sum_of({&films[2], &first_two})) == means_of(sum));
    check_close(sum.filtered(), random_film({1, 2, 3, 4}).filtered());
}

TEST_CASE("A filtered film has the same bits for samples in any order", "[film]") {
    const std::vector<Vec3> means = means_of(random_film({1, 2, 3}));
    CHECK(means_of(random_film({3, 1, 2})) == means);
    CHECK(means_of(random_film({2, 1, 3})) == means);
}

TEST_CASE("A filtered film whose tiles are written and read has the same bits", "[film]") {
    for (const double error : {0.0, 1e-3}) {
        RenderSettings settings = filtered_settings();
        settings.target_error = error;
        ImageFilm from(image, settings), to = from;
        for (const std::uint32_t number : {1, 2, 3}) add_random(from, number);
        for (const Imath::Box2i& tile : from.tiles()) send_tile(from, to, tile);
        CHECK(means_of(to) == means_of(from));
        CHECK(to.filtered().counts() == from.filtered().counts());
    }
}
