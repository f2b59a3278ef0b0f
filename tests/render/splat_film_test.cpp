#include "core/render/splat_film.h"

#include "core/sampling/sobol.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// Samples of every pixel of a window at random positions.
struct Samples {
    std::vector<Imath::V2i> pixels;
    std::vector<Vec2> places;
    std::vector<Color> colors;
};

/// `per_pixel(x, y)`: number of samples.
template <class PerPixel>
Samples random_samples(const Imath::Box2i& window, const PerPixel& per_pixel) {
    Samples samples;
    const ScrambledSobol points(1), colors(2);
    std::uint32_t next = 0;
    for (int y = window.min.y; y <= window.max.y; ++y) {
        for (int x = window.min.x; x <= window.max.x; ++x) {
            for (int i = 0; i < per_pixel(x, y); ++i, ++next) {
                samples.pixels.emplace_back(x, y);
                samples.places.push_back(Vec2(x, y) + points(next));
                const Vec2 c = colors(next);
                samples.colors.emplace_back(static_cast<float>(c.x), static_cast<float>(c.y),
                                            static_cast<float>(c.x * x + 0.1 * y));
            }
        }
    }
    return samples;
}

struct Films {
    Film samples;
    SplatFilm splats;

    Films(const Imath::Box2i& window, int side, const PixelFilter& filter, const Samples& all)
        : samples(window), splats(window, side, filter) {
        for (std::size_t i = 0; i < all.pixels.size(); ++i) {
            samples.add(all.pixels[i].x, all.pixels[i].y, all.colors[i]);
            splats.add(all.pixels[i], all.places[i], all.colors[i]);
        }
    }

    std::vector<Vec3> means(const Imath::Box2i& window) const {
        return splats.means(window, samples);
    }
};

/// Returns the weighted mean of all samples within the radius around a pixel's centre, each divided
/// by the number of samples of its own pixel.
Vec3 mean_by_definition(const Samples& all, const Film& film, const PixelFilter& filter,
                        const Imath::V2i& pixel) {
    const FilterAxis across(filter, 0), down(filter, 1);
    Vec3 sum(0);
    double weights = 0;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
        const Vec2 d = all.places[i] - Vec2(pixel) - Vec2(0.5);
        if (std::abs(d.x) > filter.radius.x || std::abs(d.y) > filter.radius.y) continue;
        const double weight =
            across(d.x) * down(d.y) / film.counts()[film.index(all.pixels[i].x, all.pixels[i].y)];
        sum += weight * Vec3(all.colors[i]);
        weights += weight;
    }
    if (weights == 0) return Vec3(0);
    const Vec3 mean = sum / weights;
    return {std::max(0.0, mean.x), std::max(0.0, mean.y), std::max(0.0, mean.z)};
}

const std::vector<PixelFilter> filters = {{FilterKind::box, {0.5, 0.5}},
                                          {FilterKind::box, {1.75, 0.25}},
                                          {FilterKind::triangle, {2, 2}},
                                          {FilterKind::gaussian, {2, 2}},
                                          {FilterKind::gaussian, {1.5, 3}, 0.5},
                                          {FilterKind::mitchell, {2, 2}},
                                          {FilterKind::sinc, {4, 4}},
                                          {FilterKind::sinc, {20, 0.3}}};

const Imath::Box2i image({5, 3}, {24, 20});

}  // namespace

TEST_CASE("A filtered pixel is the weighted mean of the samples near it", "[film]") {
    for (const PixelFilter& filter : filters) {
        CAPTURE(static_cast<int>(filter.kind), filter.radius);
        const Imath::Box2i window = sampled_window(image, filter);
        const Samples all = random_samples(window, [](int, int) { return 2; });
        for (const int side : {1, 16}) {
            const Films films(window, side, filter, all);
            const std::vector<Vec3> means = films.means(image);
            std::size_t i = 0;
            for (int y = image.min.y; y <= image.max.y; ++y) {
                for (int x = image.min.x; x <= image.max.x; ++x, ++i) {
                    const Vec3 expected = mean_by_definition(all, films.samples, filter, {x, y});
                    REQUIRE((means[i] - expected).length() < 1e-12 * (1 + expected.length()));
                }
            }
        }
    }
}

TEST_CASE("Pixels of many samples count no more than those of few", "[film]") {
    const PixelFilter filter{FilterKind::gaussian, {2, 2}};
    const Imath::Box2i window = sampled_window(image, filter);
    const Samples all = random_samples(window, [](int x, int y) { return x * y % 3 == 0 ? 8 : 1; });
    const Films films(window, 1, filter, all);
    const std::vector<Vec3> means = films.means(image);
    const Vec3 expected = mean_by_definition(all, films.samples, filter, image.min);
    CHECK((means[0] - expected).length() < 1e-12);
}

TEST_CASE("An image of one colour is unchanged by every filter", "[film]") {
    for (const PixelFilter& filter : filters) {
        CAPTURE(static_cast<int>(filter.kind), filter.radius);
        const Imath::Box2i window = sampled_window(image, filter);
        Samples all = random_samples(window, [](int, int) { return 4; });
        for (Color& color : all.colors) color = Color(0.37F, 12, 0.001F);
        for (const Vec3& mean : Films(window, 16, filter, all).means(image)) {
            REQUIRE((mean - Vec3(Color(0.37F, 12, 0.001F))).length() < 1e-12);
        }
    }
}

TEST_CASE("A single bright sample has the filter's shape", "[film]") {
    const PixelFilter filter{FilterKind::triangle, {2, 3}};
    const Imath::Box2i window({0, 0}, {16, 16});
    Samples all;
    for (int y = 0; y <= 16; ++y) {
        for (int x = 0; x <= 16; ++x) {
            all.pixels.emplace_back(x, y);
            all.places.emplace_back(x + 0.5, y + 0.5);
            all.colors.emplace_back(x == 8 && y == 8 ? 36.0F : 0.0F);
        }
    }
    const Films films(window, 16, filter, all);
    const std::vector<Vec3> means = films.means(window);
    const auto at = [&](int x, int y) { return means[films.samples.index(x, y)].x; };
    // Weights about a pixel have the sums 1 + 2 + 1 and 1 + 2 + 3 + 2 + 1.
    CHECK(at(8, 8) == Approx(6));
    CHECK(at(9, 8) == Approx(3));
    CHECK(at(7, 7) == Approx(2));
    CHECK(at(8, 10) == Approx(2));
    CHECK(at(10, 8) == 0);
    CHECK(at(8, 11) == 0);
}

TEST_CASE("Negative weights count, but no pixel is below 0", "[film]") {
    const PixelFilter filter{FilterKind::mitchell, {2, 2}};
    const Imath::Box2i window({0, 0}, {8, 0});
    const auto means = [&](float floor) {
        Samples all;
        for (int x = 0; x <= 8; ++x) {
            all.pixels.emplace_back(x, 0);
            all.places.emplace_back(x + 0.01, 0.5);
            all.colors.emplace_back(x == 4 ? 1 + floor : floor);
        }
        return Films(window, 16, filter, all).means(window);
    };
    CHECK(means(0)[2].x == 0);
    CHECK(means(1)[2].x < 1);
}

TEST_CASE("A part of a filtered image has the bits of the whole", "[film]") {
    for (const PixelFilter& filter : filters) {
        const Imath::Box2i part({9, 7}, {18, 19}), all_of_it = sampled_window(image, filter);
        const auto films_of = [&](const Imath::Box2i& window) {
            Samples some;
            const Samples all = random_samples(all_of_it, [](int, int) { return 3; });
            for (std::size_t i = 0; i < all.pixels.size(); ++i) {
                if (!window.intersects(all.pixels[i])) continue;
                some.pixels.push_back(all.pixels[i]);
                some.places.push_back(all.places[i]);
                some.colors.push_back(all.colors[i]);
            }
            return Films(window, 16, filter, some);
        };
        CHECK(films_of(sampled_window(part, filter)).means(part) ==
              films_of(all_of_it).means(part));
    }
}

TEST_CASE("A pixel that no sample reaches is black", "[film]") {
    const PixelFilter filter{FilterKind::box, {0.25, 0.25}};
    const Imath::Box2i window({0, 0}, {1, 0});
    Samples all;
    for (const double place : {0.5, 1.1}) {
        all.pixels.emplace_back(static_cast<int>(place), 0);
        all.places.emplace_back(place, 0.5);
        all.colors.emplace_back(1.0F);
    }
    CHECK(Films(window, 16, filter, all).means(window) == std::vector<Vec3>{Vec3(1), Vec3(0)});
}
