// Renderings that were stopped and resumed from a saved state.
#include <atomic>

#include "core/integrators/integrators.h"
#include "tests/render/state_bytes.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Saves a state in memory at every n-th opportunity.
class MemoryKeeper : public StateKeeper {
  public:
    explicit MemoryKeeper(int every) : every_(every) {}

    bool is_due() override { return ++asked_ % every_ == 0; }
    void keep(const std::function<void(StateWriter&)>& save) override {
        state.clear();
        StateWriter writer([&](std::string_view bytes) { state += bytes; });
        save(writer);
        ++kept;
    }

    std::string state;
    int kept = 0;

  private:
    int every_;
    std::atomic<int> asked_ = 0;
};

Rendering rendered(const TestScene& scene, const RenderSettings& settings,
                   const RunControl& control = {}) {
    return render_with(scene, *find_backend(default_backend), settings, control);
}

/// Control of a rendering that continues from a state, unless it is empty, and saves others.
class ResumableRun {
  public:
    ResumableRun(const std::string& state, int every)
        : bytes_(state), reader_(reader_of(bytes_)), keeper(every) {
        control.keeper = &keeper;
        if (!state.empty()) control.resumed = &reader_;
    }

    void stop_when_saved() {
        control.stop = &stop;
        control.observers = {{.progress = [this](double) { stop = stop || keeper.kept > 0; }}};
    }
    bool has_read_all() const { return !reader_.failed() && bytes_.empty(); }

  private:
    std::string_view bytes_;
    StateReader reader_;

  public:
    MemoryKeeper keeper;
    std::atomic<bool> stop = false;
    RunControl control;
};

/// Stops a rendering after each saved state, and resumes it in a new one.
Rendering rendered_in_parts(const TestScene& scene, const RenderSettings& settings, int every) {
    std::string state;
    while (true) {
        ResumableRun run(state, every);
        run.stop_when_saved();
        Rendering r = rendered(scene, settings, run.control);
        REQUIRE(run.has_read_all());
        if (r.complete) return r;
        state = run.keeper.state;
    }
}

/// Settings that determine how samples are taken and summed.
std::vector<RenderSettings> variants(const TestScene& scene) {
    RenderSettings uniform = scene.settings;
    uniform.samples_per_pixel = 13;
    uniform.variance = true;
    RenderSettings adaptive = uniform;
    adaptive.samples_per_pixel = 1 << 10;
    adaptive.target_error = 3e-3;
    std::vector<RenderSettings> list{uniform, adaptive};
    for (RenderSettings settings : {uniform, adaptive}) {
        settings.filter = {FilterKind::gaussian, Vec2(1.5)};
        list.push_back(settings);
    }
    return list;
}

/// A clock on which a second passes whenever it is read.
double second_per_read() {
    static std::atomic<int> reads = 0;
    return ++reads;
}

}  // namespace

TEST_CASE("An image stopped many times and resumed has the bits of one never stopped",
          "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    for (const RenderSettings& settings : variants(scene)) {
        const Rendering whole = rendered(scene, settings);
        for (const int every : {17, 61}) {
            CAPTURE(every, settings.target_error, settings.filter.radius.x);
            const Rendering resumed = rendered_in_parts(scene, settings, every);
            check_same(resumed, whole);
            CHECK(resumed.resumed_samples > 0);
        }
    }
}

TEST_CASE("An image stopped within pixels of many samples resumes to the same bits", "[resumed]") {
    const TestScene scene = mixed_scene(3, 2);
    for (RenderSettings settings : variants(scene)) {
        settings.samples_per_pixel = 1 << 13;
        const Rendering whole = rendered(scene, settings);
        check_same(rendered_in_parts(scene, settings, 7), whole);
    }
}

TEST_CASE("A stop is heeded within a pixel", "[resumed]") {
    const TestScene scene = mixed_scene(1, 1);
    RenderSettings settings = scene.settings;
    settings.samples_per_pixel = 1 << 16;
    std::atomic<bool> stop = false;
    struct Stopper : MemoryKeeper {
        explicit Stopper(std::atomic<bool>& flag) : MemoryKeeper(1 << 30), stop(flag) {}
        bool is_due() override {
            stop = ++asked > 8;
            return false;
        }
        std::atomic<bool>& stop;
        std::atomic<int> asked = 0;
    } stopper(stop);
    RunControl control;
    control.keeper = &stopper;
    control.stop = &stop;
    const Rendering r = rendered(scene, settings, control);
    CHECK_FALSE(r.complete);
    CHECK(r.samples > 1);
    CHECK(r.samples < (1 << 16));
}

TEST_CASE("An image resumed when its time is over has a sample of each pixel, and more than before",
          "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    RenderSettings settings = scene.settings;
    settings.samples_per_pixel = 64;
    for (const int every : {17, 61}) {  // the first state is of the first pass, or of a later one
        std::string state;
        std::uint64_t before = 0;
        for (int part = 0; part < 3; ++part) {
            ResumableRun run(state, every);
            if (part == 0)
                run.stop_when_saved();
            else
                run.control.deadline = Deadline(1, second_per_read);
            const Rendering r = rendered(scene, settings, run.control);
            CAPTURE(every, part);
            REQUIRE((run.keeper.kept > 0 && run.has_read_all() && !r.complete));
            CHECK(r.film.total_count() > before);
            if (part > 0) CHECK(*std::ranges::min_element(r.film.counts()) > 0);
            before = r.film.total_count();
            state = run.keeper.state;
        }
    }
}

TEST_CASE("An image resumed and stopped at once is shown as it was left", "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    for (RenderSettings settings : variants(scene)) {
        settings.target_error /= 10;
        std::string state;
        std::optional<Rendering> left;
        for (const bool again : {false, true}) {
            ResumableRun run(state, settings.target_error > 0 ? 97 : 61);
            run.stop_when_saved();
            run.stop = again;
            std::vector<Color> shown;
            run.control.observers.push_back(
                {.after_pass = [&](const RenderedPass& pass) { shown = pass.film.pixels(); }});
            Rendering r = rendered(scene, settings, run.control);
            CAPTURE(again, settings.target_error, settings.filter.radius.x);
            REQUIRE((!r.complete && run.keeper.kept > 0));
            CHECK(shown == r.film.pixels());
            if (again) check_same(r, *left);
            state = run.keeper.state;
            left = std::move(r);
        }
    }
}

TEST_CASE(
    "An image with more samples at outlines resumes to the same bits, and counts what it drops",
    "[resumed]") {
    /// Shows a light in a pixel, and here and there no number.
    struct Lamp : Integrator {
        bool shows_lights() const override { return true; }
        void emission(const CameraSamples& samples, std::span<Color> colors) const override {
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const Vec3& d = samples.rays[i].direction;
                colors[i] = Color(std::hypot(d.x, d.y) < 0.012 ? 1e4F : 0.0F);
            }
        }
        void radiance(const CameraSamples& samples, std::span<Color> colors,
                      RayCounts& counts) const override {
            emission(samples, colors);
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const auto number = static_cast<float>(samples.sources[i].point(77).x);
                colors[i] += Color(number < 0.1F ? std::nanf("") : number);
            }
            counts.camera += colors.size();
        }
    };
    TestScene scene = empty_scene(70, 50);
    scene.settings.samples_per_pixel = 13;
    scene.settings.variance = true;
    const Rendering whole = render(scene.camera, Lamp(), scene.settings);
    CHECK(*std::ranges::max_element(whole.film.counts()) == 13 * 16);
    CHECK(whole.dropped_samples > 1000);
    std::string state;
    for (bool is_complete = false; !is_complete;) {
        MemoryKeeper keeper(61);
        std::string_view bytes = state;
        StateReader reader = reader_of(bytes);
        std::atomic<bool> stop = false;
        RunControl control;
        control.keeper = &keeper;
        control.stop = &stop;
        control.observers = {{.progress = [&](double) { stop = stop || keeper.kept > 0; },
                              .after_pass = [](const RenderedPass&) {}}};
        if (!state.empty()) control.resumed = &reader;
        const Rendering r = render(scene.camera, Lamp(), scene.settings, control);
        REQUIRE_FALSE(reader.failed());
        is_complete = r.complete;
        if (is_complete) {
            CHECK(r.resumed_samples > 0);
            check_same(r, whole);
            CHECK(r.dropped_samples == whole.dropped_samples);
        }
        state = keeper.state;
    }
}

TEST_CASE("Keeping states changes nothing", "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    for (const RenderSettings& settings : variants(scene)) {
        MemoryKeeper keeper(17);
        RunControl control;
        control.keeper = &keeper;
        check_same(rendered(scene, settings, control), rendered(scene, settings));
        CHECK(keeper.kept > 3);
    }
}

TEST_CASE("A state that does not match the image is an error, and leaves no image", "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    MemoryKeeper keeper(61);
    RunControl control;
    control.keeper = &keeper;
    rendered(scene, variants(scene)[0], control);
    for (const std::size_t size : {std::size_t{0}, keeper.state.size() / 2}) {
        std::string_view bytes(keeper.state.data(), size);
        StateReader reader = reader_of(bytes);
        RunControl resumed;
        resumed.resumed = &reader;
        CHECK(rendered(scene, variants(scene)[0], resumed).counts.camera == 0);
        CHECK(reader.failed());
    }
    std::string_view bytes = keeper.state;
    StateReader reader = reader_of(bytes);
    RunControl resumed;
    resumed.resumed = &reader;
    rendered(mixed_scene(71, 50), variants(scene)[1], resumed);
    CHECK(reader.failed());
}

TEST_CASE("A state whose goals are another image's is an error", "[resumed]") {
    const TestScene scene = mixed_scene(70, 50);
    const RenderSettings settings = variants(scene)[0];
    const std::uint64_t one_goal = 1;
    const std::uint32_t goal = 8, endless = 0xFFFFFFFF;
    // Pieces of the state from its end on: what follows the goals are seven values.
    const auto is_read = [&](const std::function<void(std::vector<std::string>&)>& change) {
        struct Forger : MemoryKeeper {
            Forger() : MemoryKeeper(61) {}
            void keep(const std::function<void(StateWriter&)>& save) override {
                pieces.clear();
                StateWriter writer([&](std::string_view bytes) { pieces.emplace_back(bytes); });
                save(writer);
            }
            std::vector<std::string> pieces;
        } keeper;
        RunControl control;
        control.keeper = &keeper;
        rendered(scene, settings, control);
        change(keeper.pieces);
        std::string state;
        for (const std::string& piece : keeper.pieces) state += piece;
        std::string_view bytes = state;
        StateReader reader = reader_of(bytes);
        RunControl resumed;
        resumed.resumed = &reader;
        rendered(scene, settings, resumed);
        return !reader.failed();
    };
    const auto bytes_of = [](const auto& value) {
        return std::string(reinterpret_cast<const char*>(&value), sizeof value);
    };
    CHECK(is_read([](auto&) {}));
    CHECK_FALSE(is_read([&](auto& pieces) {
        std::string* const goals = &pieces.end()[-7];
        REQUIRE(*goals == "");
        *goals = bytes_of(goal);
        goals[-1] = bytes_of(one_goal);
    }));
    CHECK_FALSE(is_read([&](auto& pieces) { pieces.end()[-9] = bytes_of(endless); }));
}
