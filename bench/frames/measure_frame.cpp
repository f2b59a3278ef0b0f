#include "bench/frames/measure_frame.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/stopwatch.h"
#include "bench/frames/process_start.h"
#include "bench/frames/recorded_rays.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/statistics.h"
#include "core/image/io.h"
#include "core/integrators/integrators.h"
#include "core/intersect/packet_intersector.h"
#include "core/parallel/parallel.h"
#include "core/render/renderer.h"

namespace etalon::frames {
namespace {

using speed::median;

/// Approximate number of rays that are recorded to be traced again.
constexpr std::uint64_t recorded_rays = 2'000'000;

/// Returns black without tracing a ray: the time that remains is that of camera rays and film.
class Black : public Integrator {
  public:
    void radiance(const CameraSamples&, std::span<Color> colors, RayCounts&) const override {
        std::ranges::fill(colors, Color(0.0F));
    }
};

/// Measures one frame repeatedly.
class Frame {
  public:
    Frame(const Scene& scene, const RenderSettings& settings, const std::atomic<bool>* stop)
        : scene_(scene), settings_(settings) {
        control_.stop = stop;
    }

    FrameFigures measure(int repeats) {
        const ThreadLimit one_thread(1);
        std::vector<Repeat> all;
        const std::unique_ptr<Intersector> backend = built();
        const PacketIntersector intersector(scene_.geometry, *backend,
                                            chosen_backend(settings_).exact);
        Stopwatch cold;
        const std::unique_ptr<Integrator> integrator = made(intersector);
        const Rendering first = rendered(*integrator);
        const double first_seconds = cold.lap().cpu;
        RecordedRays recorded(intersector, 1 + first.counts.total() / recorded_rays);
        rendered(*made(recorded));
        while (std::ssize(all) < repeats && !is_stopped()) {
            const Repeat repeat = measure_again(*integrator, recorded, first.film);
            if (is_stopped()) break;
            all.push_back(repeat);
        }
        if (all.empty()) return {};
        take_medians(all);
        figures_.start = seconds_before_main();
        figures_.images = std::max(0.0, first_seconds - figures_.render);
        describe(first);
        return figures_;
    }

  private:
    /// CPU seconds of the stages that are measured repeatedly.
    struct Repeat {
        double build, render, intersection, film, camera, write;
    };

    Repeat measure_again(const Integrator& integrator, const RecordedRays& recorded,
                         const Film& film) const {
        Repeat r;
        Stopwatch watch;
        built();
        r.build = watch.lap().cpu;
        rendered(integrator);
        r.render = watch.lap().cpu;
        r.intersection = recorded.replay();
        r.film = add_samples(film);
        watch.lap();
        rendered(Black());
        r.camera = watch.lap().cpu - r.film;
        r.write = written(film);
        return r;
    }

    void take_medians(const std::vector<Repeat>& all) {
        const auto median_of = [&](double Repeat::*part) {
            std::vector<double> values;
            for (const Repeat& repeat : all) values.push_back(repeat.*part);
            return median(values);
        };
        figures_.repeats = static_cast<int>(all.size());
        figures_.build = median_of(&Repeat::build);
        figures_.render = median_of(&Repeat::render);
        figures_.camera = median_of(&Repeat::camera);
        figures_.intersection = median_of(&Repeat::intersection);
        figures_.film = median_of(&Repeat::film);
        figures_.write = median_of(&Repeat::write);
    }

    bool is_stopped() const { return control_.stop && *control_.stop; }

    std::unique_ptr<Intersector> built() const {
        return chosen_backend(settings_).build(scene_.geometry);
    }

    std::unique_ptr<Integrator> made(const BatchIntersector& intersector) const {
        std::vector<std::string> problems;
        return find_integrator(settings_.integrator)
            ->make(scene_, intersector, settings_, problems);
    }

    Rendering rendered(const Integrator& integrator) const {
        return render(scene_.camera, integrator, settings_, control_);
    }

    /// Returns the seconds that adding so many samples to a film takes.
    static double add_samples(const Film& like) {
        Film film(like.window());
        Stopwatch watch;
        const Imath::Box2i& w = like.window();
        for (int y = w.min.y; y <= w.max.y; ++y) {
            for (int x = w.min.x; x <= w.max.x; ++x) {
                for (std::uint32_t n = like.counts()[like.index(x, y)]; n-- > 0;) {
                    film.add(x, y, Color(0.5F));
                }
            }
        }
        return watch.lap().cpu;
    }

    static double written(const Film& film) {
        RenderedImage image;
        image.window = film.window();
        image.width = image.window.max.x + 1;
        image.height = image.window.max.y + 1;
        image.pixels = film.pixels();
        const std::filesystem::path path =
            std::filesystem::temp_directory_path() / fmt::format("etalon_frame_{}.exr", getpid());
        Stopwatch watch;
        write_image(path.string(), image);
        const double seconds = watch.lap().cpu;
        std::filesystem::remove(path);
        return seconds;
    }

    void describe(const Rendering& rendering) {
        figures_.backend = chosen_backend(settings_).name;
        figures_.width = settings_.resolution.x;
        figures_.height = settings_.resolution.y;
        figures_.samples = static_cast<int>(rendering.film.total_count() / rendering.film.size());
        figures_.rays = rendering.counts.total();
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    RunControl control_;
    FrameFigures figures_;
};

}  // namespace

Result<FrameFigures> measure_frame(const std::string& name, const Plan& plan) {
    Stopwatch watch;
    bench::NamedScene named = bench::bench_scene(name);
    const double load = watch.lap().cpu;
    write_message(named.messages);
    if (!named.scene) return {{}, fmt::format("{}: no scene to measure", name)};
    bench::set_width(named.settings, plan.width);
    if (plan.samples > 0) named.settings.samples_per_pixel = plan.samples;
    if (!plan.backend.empty()) named.settings.backend = plan.backend;
    FrameFigures figures = Frame(*named.scene, named.settings, plan.stop).measure(plan.repeats);
    figures.scene = name;
    figures.load = load;
    return {figures, {}};
}

}  // namespace etalon::frames
