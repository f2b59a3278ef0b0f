#include "core/render/filtered_errors.h"

#include "core/color/srgb.h"
#include "core/render/filter_axis.h"
#include "core/render/pass_errors.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// Returns the relative squared change of a value, or of the light for which it stands.
double relative_change(double from, double to, bool decodes) {
    const auto light = [&](double value) { return decodes ? srgb_decoded(value) : value; };
    const double change = light(to) - light(from);
    return change * change / (light(to) * light(to) + 0.01);
}

/// Adds a sample of a colour at the centre of each pixel.
void add(ImageFilm& film, float value) {
    const Imath::Box2i& window = film.samples().window();
    for (int y = window.min.y; y <= window.max.y; ++y) {
        for (int x = window.min.x; x <= window.max.x; ++x) {
            const Vec2 place(x + 0.5, y + 0.5);
            Color color(value);
            film.add(std::array{PixelRun{{x, y}, 0, 1}}, {&place, 1}, {&color, 1});
        }
    }
}

}  // namespace

TEST_CASE("Filtered errors: given the error of a sampled pixel, then it spreads by the filter",
          "[film][estimate]") {
    const Imath::Box2i window({3, 2}, {8, 6});
    RenderSettings settings;
    settings.filter = {FilterKind::triangle, {2, 1}};
    for (const bool decodes : {false, true}) {
        settings.display_colors = decodes;
        Film image(window);
        for (int y = 2; y <= 6; ++y) {
            for (int x = 3; x <= 8; ++x)
                image.add(x, y, Color(0.1F * static_cast<float>(x), 0.5F, 0));
        }
        std::vector<Vec3> before;
        for (std::size_t i = 0; i < image.size(); ++i) {
            before.push_back(image.mean(i) - Vec3(1e-5, 0, 0));
        }
        const Imath::Box2i samples = sampled_window(window, settings.filter);
        const FilteredErrors errors = filtered_errors(image, before, samples, settings);

        const std::vector<double> across = FilterAxis(settings.filter, 0).mean_squares(),
                                  down = FilterAxis(settings.filter, 1).mean_squares();
        const int reach_x = static_cast<int>(across.size()) / 2,
                  reach_y = static_cast<int>(down.size()) / 2;
        const Imath::V2i size = samples.size() + Imath::V2i(1);
        REQUIRE(errors.factors.size() == static_cast<std::size_t>(size.x) * size.y);
        double change = 0;
        std::vector<double> factors(errors.factors.size(), 0.0);
        for (std::size_t i = 0; i < image.size(); ++i) {
            const int px = 3 + static_cast<int>(i) % 6, py = 2 + static_cast<int>(i) / 6;
            const double here = relative_change(before[i].x, image.mean(i).x, decodes);
            change += here / 3 / static_cast<double>(image.size());
            for (int y = samples.min.y; y <= samples.max.y; ++y) {
                for (int x = samples.min.x; x <= samples.max.x; ++x) {
                    if (std::abs(x - px) > reach_x || std::abs(y - py) > reach_y) continue;
                    factors[(y - samples.min.y) * size.x + (x - samples.min.x)] +=
                        here * 1e10 * across[x - px + reach_x] * down[y - py + reach_y] *
                        static_cast<double>(factors.size()) / static_cast<double>(image.size());
                }
            }
        }
        CAPTURE(decodes);
        CHECK(errors.change == Approx(change).epsilon(1e-3));
        for (std::size_t i = 0; i < factors.size(); ++i) {
            CHECK(errors.factors[i].x == Approx(factors[i]).epsilon(1e-3));
        }
    }
}

TEST_CASE("Filtered errors: given several passes, then each change is from the last image",
          "[film][estimate]") {
    RenderSettings settings;
    settings.filter = {FilterKind::gaussian, {2, 2}};
    ImageFilm image({{0, 0}, {9, 9}}, settings);
    PassErrors errors(image, settings);
    const auto change = [&] {
        errors.look();
        return errors.expected().value_or(0) * (std::exp2(errors.estimate().rate(0, 0)) - 1);
    };
    add(image, 1);
    CHECK(change() == 0);
    add(image, 3);
    CHECK(change() == Approx(relative_change(1, 2, false)));
    for (int i = 0; i < 2; ++i) add(image, 4);
    CHECK(change() == Approx(relative_change(2, 3, false)));
}
