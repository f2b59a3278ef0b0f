#include "core/render/film.h"

#include "core/render/state.h"
#include "tests/render/state_bytes.h"

using namespace etalon;
using namespace etalon::test;

TEST_CASE("A film has means, numbers and variances of its samples", "[film]") {
    Film film({{3, 5}, {4, 5}}, true);
    for (const float value : {1.0F, 2.0F, 6.0F}) film.add(4, 5, Color(value, 0.5F, -value));
    CHECK(film.pixels() == std::vector<Color>{Color(0.0F), Color(3.0F, 0.5F, -3.0F)});
    CHECK(film.counts() == std::vector<std::uint32_t>{0, 3});
    CHECK(film.total_count() == 3);
    // (4 + 1 + 9) / (3 - 1)
    CHECK(film.variances() == std::vector<Color>{Color(0.0F), Color(7.0F, 0.0F, 7.0F)});
}

TEST_CASE("A film has the same sums of runs of samples as of single ones", "[film]") {
    const std::vector<Color> samples{Color(1, 2, 3), Color(4, 0.5F, -1), Color(7), Color(0.1F)};
    const std::vector<PixelRun> runs{{{4, 5}, 0, 3}, {{3, 6}, 3, 4}};
    for (const bool with_squares : {false, true}) {
        Film together({{3, 5}, {5, 6}}, with_squares), alone = together;
        for (int round = 0; round < 2; ++round) {
            together.add(runs, samples);
            for (std::size_t i = 0; i < 3; ++i) alone.add(4, 5, samples[i]);
            alone.add(3, 6, samples[3]);
        }
        CHECK(together.pixels() == alone.pixels());
        CHECK(together.counts() == alone.counts());
        if (with_squares) CHECK(together.variances() == alone.variances());
    }
}

TEST_CASE("A film's tile that is written and read has its samples and their variance", "[film]") {
    Film from({{3, 5}, {6, 8}}, true), to = from;
    const Imath::Box2i tile({4, 6}, {6, 7});
    for (int i = 0; i < 48; ++i) {
        from.add(3 + i % 4, 5 + i / 4 % 4, Color(static_cast<float>(i * i)));
    }
    send_tile(from, to, tile);
    for (int i = 0; i < 16; ++i) {
        const int x = 3 + i % 4, y = 5 + i / 4;
        const std::size_t pixel = from.index(x, y);
        const bool is_in_tile = tile.intersects(Imath::V2i(x, y));
        CAPTURE(x, y);
        CHECK(to.counts()[pixel] == (is_in_tile ? 3 : 0));
        CHECK(to.sum(pixel) == (is_in_tile ? from.sum(pixel) : Vec3(0)));
        CHECK(to.variances()[pixel] == (is_in_tile ? from.variances()[pixel] : Color(0.0F)));
    }
}

TEST_CASE("One sample has no variance, and rounding leaves none below 0", "[film]") {
    Film film({{0, 0}, {0, 0}}, true);
    film.add(0, 0, Color(0.1F));
    CHECK(film.variances()[0] == Color(0.0F));
    for (int i = 0; i < 1000; ++i) film.add(0, 0, Color(0.1F));
    CHECK(film.variances()[0].x >= 0);
    CHECK(film.variances()[0].x < 1e-12F);
}

TEST_CASE("Cells of corners have the samples of all four", "[film]") {
    Film corners({{0, 0}, {1, 1}}, true);
    for (const auto& [x, y] : {Imath::V2i(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        corners.add(x, y, Color(static_cast<float>(x + 2 * y)));
    }
    const Film cell = corners.cells();
    CHECK(cell.size() == 1);
    CHECK(cell.counts()[0] == 4);
    CHECK(cell.pixels()[0].x == 1.5F);
    CHECK(cell.variances()[0].x == Approx(5.0 / 3));
}

TEST_CASE("Films add up to the same means in any order, for sums of any size", "[film]") {
    const Imath::Box2i window({0, 0}, {0, 0});
    std::vector<Film> films;
    for (const float value : {1e8F, 3.0F, -1e8F, 1e-9F, 7e15F, -7e15F}) {
        films.emplace_back(window).add(0, 0, Color(value, 2 * value, value / 3));
    }
    const auto mean_in_order = [&](const std::vector<int>& order) {
        Film sum(window);
        for (const int i : order) sum.add(films[i]);
        return sum.mean(0);
    };
    const Vec3 mean = mean_in_order({0, 1, 2, 3, 4, 5});
    CHECK(mean.x == Approx((3 + 1e-9) / 6).epsilon(1e-15));
    std::vector<int> order{0, 1, 2, 3, 4, 5};
    while (std::next_permutation(order.begin(), order.end())) CHECK(mean_in_order(order) == mean);
}

TEST_CASE("Films that are sums already add up to the same means", "[film]") {
    const Imath::Box2i window({0, 0}, {0, 0});
    const auto sum_of = [&](std::initializer_list<float> values) {
        Film sum(window);
        for (const float value : values) {
            Film film(window);
            film.add(0, 0, Color(value));
            sum.add(film);
        }
        return sum;
    };
    Film groups = sum_of({3, -7e15F});
    groups.add(sum_of({7e15F, 1e-9F}));
    CHECK(groups.counts() == std::vector<std::uint32_t>{4});
    CHECK(groups.mean(0) == sum_of({3, -7e15F, 7e15F, 1e-9F}).mean(0));
}
