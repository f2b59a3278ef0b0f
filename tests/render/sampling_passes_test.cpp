// Renderings that end at a target error or a time limit.
#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>

#include "core/image/metrics/metrics.h"
#include "core/parallel/parallel.h"
#include "core/render/image_pixels.h"
#include "core/render/uniform_passes.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

Rendering rendered(const Scene& scene, const RenderSettings& settings,
                   const RunControl& control = {}) {
    return render_with(scene, *find_backend(default_backend), settings, control);
}

RenderSettings samples(const TestScene& scene, int count, std::uint32_t seed = 0) {
    RenderSettings settings = scene.settings;
    settings.samples_per_pixel = count;
    settings.seed = seed;
    return settings;
}

RenderSettings up_to_error(const TestScene& scene, double error, std::uint32_t seed = 0) {
    RenderSettings settings = samples(scene, 1 << 14, seed);
    settings.target_error = error;
    return settings;
}

const TestScene& scene() {
    static const TestScene mixed = mixed_scene(96, 72);
    return mixed;
}

const std::vector<Color>& truth() {
    static const std::vector<Color> pixels =
        image_pixels(rendered(scene(), samples(scene(), 1024, 99)).film, scene().settings);
    return pixels;
}

double error_of(const Rendering& rendering) {
    return relmse(image_pixels(rendering.film, scene().settings), truth());
}

std::atomic<int> clock_reads = 0;

/// A clock on which a second passes whenever it is read.
double second_per_read() {
    return ++clock_reads;
}

double set_time = 0;

}  // namespace

TEST_CASE("An image ends near the target error, with fewer samples than uniform sampling",
          "[passes]") {
    for (const double error : {1e-3, 4e-4}) {
        const Rendering r = rendered(scene(), up_to_error(scene(), error));
        const double real = error_of(r);
        CAPTURE(error, *r.expected_error, real, r.samples);
        CHECK(r.complete);
        CHECK(*r.expected_error <= 1.03 * error);
        CHECK(real < 1.25 * error);
        CHECK(real > 0.75 * error);
        const auto uniform = static_cast<int>(r.samples);
        CHECK(error_of(rendered(scene(), samples(scene(), uniform))) > real);
    }
}

TEST_CASE("An adaptive image has the same mean as a uniform one", "[passes]") {
    Vec3 adaptive(0), uniform(0);
    constexpr int seeds = 16;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        adaptive += mean(rendered(scene(), up_to_error(scene(), 1e-3, seed)).film.pixels());
        uniform += mean(rendered(scene(), samples(scene(), 16, seed)).film.pixels());
    }
    const Vec3 exact = mean(truth());
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k, exact[k]);
        CHECK(uniform[k] / seeds == Approx(exact[k]).epsilon(2e-4));
        CHECK(adaptive[k] / seeds == Approx(exact[k]).epsilon(2e-4));
    }
}

TEST_CASE("An adaptive image is the same for every backend and number of threads", "[passes]") {
    const RenderSettings settings = up_to_error(scene(), 1e-3);
    const Rendering reference = rendered(scene(), settings);
    for (const char* backend : {"grid", "embree", "embree-user"}) {
        for (const int threads : {1, 2}) {
            const ThreadLimit limit(threads);
            const Rendering other = render_with(scene(), *find_backend(backend), settings);
            CHECK(other.film.counts() == reference.film.counts());
            CHECK(other.film.pixels() == reference.film.pixels());
        }
    }
}

TEST_CASE("No pixel has more samples than allowed, nor a sixty-fourth of another's", "[passes]") {
    RenderSettings settings = up_to_error(scene(), 1e-12);
    settings.samples_per_pixel = 256;
    const Rendering r = rendered(scene(), settings);
    const auto [least, most] = std::minmax_element(r.film.counts().begin(), r.film.counts().end());
    CHECK(*most == 256);
    CHECK(*least > 256 / 64);
    CHECK(*r.expected_error > 1e-12);
}

TEST_CASE("No image ends before eight samples of each pixel within its filter", "[passes]") {
    const TestScene small = mixed_scene(12, 9);
    const auto least = [&](const Vec2& radius, int most) {
        RenderSettings settings = up_to_error(small, 10);
        settings.samples_per_pixel = most;
        settings.filter.radius = radius;
        const Rendering r = rendered(small, settings);
        CHECK(r.complete);
        CHECK_FALSE(r.misses_target);
        return *std::ranges::min_element(r.film.counts());
    };
    CHECK(least(Vec2(0.5), 1 << 14) == 8);
    CHECK(least(Vec2(2), 1 << 14) == 8);
    CHECK(least(Vec2(0.125), 1 << 14) == 128);
    CHECK(least(Vec2(0.125, 2), 1 << 14) == 32);
    CHECK(least(Vec2(2, 0.125), 1 << 14) == 32);
    CHECK(least(Vec2(0.5), 6) == 4);  // unless fewer are allowed
}

TEST_CASE("The progress of an image with a target error is a fraction that ends near 1",
          "[passes]") {
    const TestScene small = mixed_scene(24, 18);
    double progress = -1;
    RunControl control;
    control.observers = {{.progress = [&](double part) {
        CHECK((part >= 0 && part <= 1));
        progress = part;
    }}};
    const ThreadLimit alone(1);
    const Rendering r = rendered(small, up_to_error(small, 1e-2), control);
    CHECK(r.complete);
    CHECK(progress > 0.2);
}

TEST_CASE("An image is complete when pixels with a rate have that many times its samples",
          "[passes][rates]") {
    const Film film({{0, 0}, {1, 0}});
    const Deadline never;
    UniformPasses passes(8, 2, never, {1, 4});
    CHECK(passes.next(film)->of_pixel == std::vector<std::uint32_t>{1, 4});
    CHECK(passes.next(film)->of_pixel == std::vector<std::uint32_t>{2, 8});
    CHECK(passes.progress(10) == 0.25);
    CHECK(passes.progress(40) == 1);
    CHECK_FALSE(passes.is_complete(39));
    CHECK(passes.is_complete(40));
}

TEST_CASE("All allowed samples are taken before a target error is missed", "[passes]") {
    for (const int most : {1, 6, 32, 37}) {
        RenderSettings settings = up_to_error(scene(), 1e-12);
        settings.samples_per_pixel = most;
        const Rendering r = rendered(scene(), settings);
        CAPTURE(most);
        CHECK(r.complete);
        CHECK(r.misses_target);
        CHECK(*std::ranges::min_element(r.film.counts()) == static_cast<std::uint32_t>(most));
        if (most < 32) continue;
        CHECK(*r.expected_error < 1.5 * error_of(r));
        CHECK(*r.expected_error > error_of(r) / 1.5);
    }
}

TEST_CASE("Images of one pixel, and of one sample at most, are valid", "[passes]") {
    const TestScene small = mixed_scene(1, 1);
    const Rendering r = rendered(small, up_to_error(small, 1e-4));
    CHECK(r.complete);
    CHECK(r.film.counts()[0] >= 2);
    RenderSettings single = up_to_error(scene(), 1e-4);
    single.samples_per_pixel = 1;
    const Rendering unknown = rendered(scene(), single);
    CHECK(unknown.film.total_count() == scene().settings.resolution.x * 72U);
    CHECK_FALSE(unknown.expected_error.has_value());
}

TEST_CASE("Every pass of an image is shown completely", "[passes]") {
    const RenderSettings settings = samples(scene(), 6);
    std::vector<std::uint32_t> counts;
    RunControl control;
    const auto note = [&](const RenderedPass& pass) {
        const auto& all = pass.film.counts();
        CHECK(*std::min_element(all.begin(), all.end()) ==
              *std::max_element(all.begin(), all.end()));
        CHECK_FALSE(pass.expected_error.has_value());
        counts.push_back(all[0]);
    };
    control.observers = {{.after_pass = note}};
    rendered(scene(), settings, control);
    CHECK(counts == std::vector<std::uint32_t>{1, 2, 4, 6});
}

TEST_CASE("Every tile is reported with its samples, from the thread that has them", "[passes]") {
    const RenderSettings settings = samples(scene(), 4);
    std::mutex mutex;
    std::vector<Color> colors(scene().settings.resolution.x * scene().settings.resolution.y);
    std::size_t told = 0;
    RunControl control;
    control.observers = {{.after_tile = [&](const RenderedTile& t) {
        const std::lock_guard lock(mutex);
        CHECK(t.seconds > 0);
        for (int y = t.tile.min.y; y <= t.tile.max.y; ++y) {
            for (int x = t.tile.min.x; x <= t.tile.max.x; ++x, ++told) {
                const std::size_t pixel = t.samples.index(x, y);
                colors[pixel] = Color(t.samples.mean(pixel));
            }
        }
    }}};
    const Rendering r = rendered(scene(), settings, control);
    CHECK(told == 3 * colors.size());  // passes to 1, 2 and 4 samples
    CHECK(colors == r.film.pixels());
}

TEST_CASE("An image ends at its time limit", "[passes]") {
    clock_reads = 0;
    const RenderSettings settings = samples(scene(), 1 << 20);
    RunControl control;
    control.deadline = Deadline(2000, second_per_read);
    const Rendering r = rendered(scene(), settings, control);
    CHECK(r.samples >= 4);  // the clock is read about 500 times per pass
    CHECK(r.samples < 2000);
    CHECK_FALSE(r.complete);
}

TEST_CASE("However short the time is, every pixel has a sample", "[passes]") {
    for (const double error : {0.0, 1e-4}) {
        const RenderSettings settings = up_to_error(scene(), error);
        RunControl control;
        control.deadline = Deadline(1, second_per_read);
        const Rendering r = rendered(scene(), settings, control);
        const std::vector<std::uint32_t>& counts = r.film.counts();
        CHECK(*std::min_element(counts.begin(), counts.end()) == 1);
        CHECK(*std::max_element(counts.begin(), counts.end()) == 1);
        CHECK_FALSE(r.complete);
        CHECK_FALSE(r.expected_error.has_value());
    }
    RunControl control;
    control.deadline = Deadline(1, second_per_read);
    CHECK(rendered(scene(), samples(scene(), 1), control).complete);
}

TEST_CASE("What there is of a pass that was stopped is shown, once", "[passes]") {
    std::atomic<bool> stop = false;
    const RenderSettings settings = samples(scene(), 64);
    RunControl control;
    control.stop = &stop;
    int shown = 0;
    const auto note = [&](const RenderedPass& pass) {
        CHECK(pass.film.total_count() > 0);
        ++shown;
    };
    control.observers = {{.progress = [&](double) { stop = true; }, .after_pass = note}};
    rendered(scene(), settings, control);
    CHECK(shown == 1);
}

TEST_CASE("The last pass before a deadline is as large as there is time for", "[passes]") {
    const Film film({{0, 0}, {0, 0}});
    set_time = 0;
    const Deadline soon(10, [] { return set_time; });
    UniformPasses passes(1000, 1, soon);
    const auto next_at = [&](double time) {
        set_time = time;
        const std::optional<SamplingGoal> goal = passes.next(film);
        return goal ? goal->all : 0;
    };
    CHECK(next_at(0) == 1);
    CHECK(next_at(1) == 2);
    CHECK(next_at(4) == 4);  // the time suffices for five
    CHECK(next_at(8) == 5);  // 4 took 8 seconds of 10
    CHECK(next_at(9.5) == 0);
    const Deadline never;
    UniformPasses all(5, 1, never);
    for (const std::uint32_t goal : {1U, 2U, 4U, 5U}) CHECK(all.next(film)->all == goal);
    CHECK_FALSE(all.next(film).has_value());
}

TEST_CASE("A limit of more than an image: given little of it left, then no samples are saved",
          "[passes]") {
    set_time = 0;
    RunControl control;
    control.stop_at = Deadline(10, [] { return set_time; });
    set_time = 9;
    const Rendering late = rendered(scene(), samples(scene(), 8), control);
    CHECK(late.samples == 8);
    CHECK(late.complete);
    set_time = 10;
    const Rendering over = rendered(scene(), samples(scene(), 8), control);
    CHECK(over.samples == 0);
    CHECK_FALSE(over.complete);
}

TEST_CASE("What was rendered before it was resumed tells nothing of the time left", "[passes]") {
    const Film film({{0, 0}, {0, 0}});
    const std::uint32_t goal = 4;
    const auto goal_at = [&](double time, std::uint64_t samples, bool again) {
        set_time = 0;
        const Deadline soon(10, [] { return set_time; });
        UniformPasses passes(1000, 1, soon);
        StateReader bytes([&](char* to, std::size_t size) {
            REQUIRE(size == sizeof goal);
            std::memcpy(to, &goal, size);
            return true;
        });
        passes.restore(bytes, samples);
        if (again) passes.next(film);
        set_time = time;
        const std::optional<SamplingGoal> next = passes.next(film);
        return next ? next->all : 0;
    };
    CHECK(goal_at(0.1, 4, false) == 8);  // after a whole pass
    CHECK(goal_at(9.9, 4, false) == 8);
    CHECK(goal_at(1, 3, false) == 8);  // within a pass: its last sample took a second of ten
    CHECK(goal_at(5, 3, false) == 5);  // five seconds
    CHECK(goal_at(2, 4, true) == 16);  // a pass of four took two seconds
    CHECK(goal_at(8, 4, true) == 9);   // eight seconds
}

TEST_CASE("Passes of few samples are made larger, but for the first", "[passes]") {
    const Film film({{0, 0}, {0, 0}});
    const Deadline never;
    const auto goals = [&](std::uint32_t samples, std::size_t pixels, SampleRates rates = {}) {
        UniformPasses passes(samples, pixels, never, std::move(rates), 1000);
        std::vector<std::uint32_t> list;
        while (const std::optional<SamplingGoal> goal = passes.next(film)) {
            list.push_back(goal->all);
        }
        return list;
    };
    CHECK(goals(64, 1000) == std::vector<std::uint32_t>{1, 2, 4, 8, 16, 32, 64});
    CHECK(goals(64, 200) == std::vector<std::uint32_t>{1, 6, 12, 24, 48, 64});
    CHECK(goals(64, 10) == std::vector<std::uint32_t>{1, 64});
    CHECK(goals(1, 10) == std::vector<std::uint32_t>{1});
    CHECK(goals(64, 100, SampleRates(100, 2)) == std::vector<std::uint32_t>{1, 6, 12, 24, 48, 64});
    // Rates may be a damaged file's.
    CHECK(goals(64, 100, SampleRates(100, 0)) == std::vector<std::uint32_t>{1, 64});
}

TEST_CASE("Pixels do not depend on how many passes there are", "[passes]") {
    const RenderSettings settings = samples(scene(), 7);
    RunControl watched;
    watched.observers = {{.after_pass = [](const RenderedPass&) {}}};
    CHECK(rendered(scene(), settings, {}).film.pixels() ==
          rendered(scene(), settings, watched).film.pixels());
}
