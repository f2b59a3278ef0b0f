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
#include "core/parallel/parallel.h"
#include "core/render/renderer.h"

namespace etalon::frames {
namespace {

using speed::median;

/// Number of rays that are kept to be asked again, about.
constexpr std::uint64_t recorded_rays = 2'000'000;

/// Sees black everywhere, at once: what is left of a rendering are its camera rays and its film.
class Black : public Integrator {
  public:
    void radiance(const CameraSamples&, std::span<Color> colors, RayCounts&) const override {
        std::ranges::fill(colors, Color(0.0F));
    }
};

/// One frame, measured again and again.
class Frame {
  public:
    Frame(const Scene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(settings) {}

    FrameFigures measure(int repeats) {
        const ThreadLimit one_thread(1);
        std::vector<double> builds, renders, cameras, intersections, films, writes;
        const std::unique_ptr<Intersector> intersector = built();
        Stopwatch cold;
        const std::unique_ptr<Integrator> integrator = made(*intersector);
        const Rendering first = rendered(*integrator);
        const double first_seconds = cold.lap().cpu;
        RecordedRays recorded(*intersector, 1 + first.counts.total() / recorded_rays);
        rendered(*made(recorded));
        for (int i = 0; i < repeats; ++i) {
            Stopwatch watch;
            built();
            builds.push_back(watch.lap().cpu);
            rendered(*integrator);
            renders.push_back(watch.lap().cpu);
            intersections.push_back(recorded.replay());
            films.push_back(add_samples(first.film));
            watch.lap();
            render(scene_.camera, Black(), settings_);
            cameras.push_back(watch.lap().cpu - films.back());
            writes.push_back(written(first.film));
        }
        figures_.start = seconds_before_main();
        figures_.build = median(builds);
        figures_.render = median(renders);
        figures_.images = std::max(0.0, first_seconds - figures_.render);
        figures_.camera = median(cameras);
        figures_.intersection = median(intersections);
        figures_.film = median(films);
        figures_.write = median(writes);
        describe(first);
        return figures_;
    }

  private:
    std::unique_ptr<Intersector> built() const {
        return chosen_backend(settings_).build(scene_.geometry);
    }

    std::unique_ptr<Integrator> made(const BatchIntersector& intersector) const {
        std::vector<std::string> problems;
        return find_integrator(settings_.integrator)
            ->make(scene_, intersector, settings_, problems);
    }

    Rendering rendered(const Integrator& integrator) const {
        return render(scene_.camera, integrator, settings_);
    }

    /// Seconds that adding so many samples to a film takes.
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
    FrameFigures figures_;
};

}  // namespace

FrameFigures measure_frame(const Scene& scene, const RenderSettings& settings, int repeats) {
    return Frame(scene, settings).measure(repeats);
}

Result<FrameFigures> measure_frame(const std::string& name, const Plan& plan) {
    Stopwatch watch;
    bench::NamedScene named = bench::bench_scene(name);
    const double load = watch.lap().cpu;
    write_message(named.messages);
    if (!named.scene) return {{}, fmt::format("{}: no scene to measure", name)};
    bench::set_width(named.settings.resolution, plan.width);
    if (plan.samples > 0) named.settings.samples_per_pixel = plan.samples;
    if (!plan.backend.empty()) named.settings.backend = plan.backend;
    FrameFigures figures = measure_frame(*named.scene, named.settings, plan.repeats);
    figures.scene = name;
    figures.load = load;
    return {figures, {}};
}

}  // namespace etalon::frames
