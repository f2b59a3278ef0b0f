#include "bench/convergence/measure_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "app/common/backends.h"
#include "app/common/stopwatch.h"
#include "bench/convergence/mean_difference.h"
#include "core/image/metrics/metrics.h"
#include "core/integrators/integrators.h"
#include "core/parallel/parallel.h"
#include "core/render/image_pixels.h"
#include "core/render/renderer.h"

namespace etalon::convergence {
namespace {

constexpr std::uint32_t reference_seed = 0x7ea1;

/// A target error that is never reached: an adaptive image ends at its number of samples.
constexpr double no_error = 1e-30;
constexpr int any_samples = 1 << 24;

/// A scene prepared for repeated rendering.
class PreparedScene {
  public:
    PreparedScene(const Scene& scene, const std::string& backend)
        : scene_(scene), intersector_(find_backend(backend)->build(scene.geometry)) {
        build_seconds_ = watch_.lap().cpu;
    }

    /// Adds to `problems` why images of the scene are replaced.
    std::unique_ptr<Integrator> integrator(const RenderSettings& settings,
                                           std::vector<std::string>& problems) const {
        return find_integrator(settings.integrator)
            ->make(scene_, *intersector_, settings, problems);
    }

    const Camera& camera() const { return scene_.camera; }
    double build_seconds() const { return build_seconds_; }

  private:
    Stopwatch watch_;
    const Scene& scene_;
    std::unique_ptr<Intersector> intersector_;
    double build_seconds_ = 0;  ///< CPU time
};

/// Renders one image and measures its error after every pass. The time of measuring is not counted.
class SeedRun {
  public:
    SeedRun(const PreparedScene& prepared, const RenderSettings& settings,
            const ReferenceImage& reference, const ConvergenceConfig& config,
            const std::atomic<bool>& stop)
        : prepared_(prepared),
          settings_(settings),
          reference_(reference),
          config_(config),
          stop_(stop) {}

    /// Empty if it was stopped.
    std::vector<Point> points(const std::string& sampler, std::uint32_t seed) {
        RenderSettings settings = settings_;
        const bool is_adaptive = sampler == "adaptive";
        settings.samples_per_pixel = is_adaptive ? any_samples : config_.samples;
        settings.target_error = is_adaptive ? no_error : 0;
        settings.sampler = sampler == "random" ? Sampler::random : Sampler::sobol;
        settings.seed = seed;
        RunControl control;
        control.stop = &enough_;
        control.observers = {{.progress = [&](double) { enough_ = enough_ || stop_; },
                              .after_pass = [&](const RenderedPass& pass) { note(pass.film); }}};
        watch_.lap();
        const auto integrator = prepared_.integrator(settings, replaced_images_);
        integrator_seconds_ = watch_.lap().cpu;
        render(prepared_.camera(), *integrator, settings, control);
        std::ranges::move(integrator->late_problems(), std::back_inserter(replaced_images_));
        return stop_ ? std::vector<Point>() : std::move(points_);
    }

    /// CPU time of preparing the integrator.
    double integrator_seconds() const { return integrator_seconds_; }
    const std::vector<std::string>& replaced_images() const { return replaced_images_; }

  private:
    void note(const Film& film) {
        seconds_ += watch_.lap().cpu;
        const std::vector<Color> pixels = image_pixels(film, settings_);
        const auto samples = static_cast<double>(film.total_count());
        Point point{samples / static_cast<double>(film.size()), seconds_,
                    mse(pixels, reference_.pixels), relmse(pixels, reference_.pixels)};
        point.mse_least = point.mse_most = point.mse;
        point.mean_difference = mean_difference(mean(pixels), mean(reference_.pixels));
        points_.push_back(point);
        enough_ = point.samples >= config_.samples;
        watch_.lap();
    }

    const PreparedScene& prepared_;
    const RenderSettings& settings_;
    const ReferenceImage& reference_;
    const ConvergenceConfig& config_;
    const std::atomic<bool>& stop_;
    std::atomic<bool> enough_ = false;
    Stopwatch watch_;
    double seconds_ = 0, integrator_seconds_ = 0;
    std::vector<std::string> replaced_images_;
    std::vector<Point> points_;
};

/// Averages points pass by pass, up to the smallest number of passes.
std::vector<Point> mean_of(const std::vector<std::vector<Point>>& seeds) {
    std::size_t passes = std::numeric_limits<std::size_t>::max();
    for (const auto& points : seeds) passes = std::min(passes, points.size());
    std::vector<Point> means;
    const auto count = static_cast<double>(seeds.size());
    for (std::size_t i = 0; i < passes; ++i) {
        Point mean;
        mean.mse_least = std::numeric_limits<double>::infinity();
        std::vector<Vec3> differences;
        for (const auto& points : seeds) {
            mean.samples += points[i].samples / count;
            mean.cpu_seconds += points[i].cpu_seconds / count;
            mean.mse += points[i].mse / count;
            mean.relmse += points[i].relmse / count;
            mean.mse_least = std::min(mean.mse_least, points[i].mse);
            mean.mse_most = std::max(mean.mse_most, points[i].mse);
            differences.push_back(*points[i].mean_difference);
        }
        set_mean_difference(differences, mean);
        means.push_back(mean);
    }
    return means;
}

/// Returns the curves to measure, still without points.
std::vector<Curve> wanted(const ConvergenceConfig& config, const std::string& integrator) {
    std::vector<Curve> curves;
    const auto add = [&](const std::string& sampler, const std::string& backend) {
        curves.push_back({fmt::format("{}, {}, {}", integrator, sampler, backend), sampler,
                          integrator, backend});
    };
    for (const std::string& sampler : config.samplers) add(sampler, config.backends.front());
    for (std::size_t i = 1; i < config.backends.size(); ++i) {
        add(config.samplers.back(), config.backends[i]);
    }
    return curves;
}

}  // namespace

const std::vector<std::string>& sampler_names() {
    static const std::vector<std::string> names{"random", "sobol", "adaptive"};
    return names;
}

ReferenceImage render_reference(const Scene& scene, const RenderSettings& scene_settings,
                                const ConvergenceConfig& config, const RunProgress& run) {
    RenderSettings settings = scene_settings;
    settings.samples_per_pixel = reference_times * config.samples;
    settings.seed = reference_seed;
    RunControl control;
    control.stop = &run.stop;
    control.observers = {{.progress = run.progress}};
    const PreparedScene prepared(scene, config.backends.front());
    std::vector<std::string> problems;  // the curves have the same
    const auto integrator = prepared.integrator(settings, problems);
    const Rendering r = render(scene.camera, *integrator, settings, control);
    return {image_pixels(r.film, settings),
            fmt::format("{} samples per pixel", settings.samples_per_pixel)};
}

std::vector<Curve> measure(const Scene& scene, const RenderSettings& settings,
                           const ReferenceImage& reference, const ConvergenceConfig& config,
                           const RunProgress& run) {
    const ThreadLimit alone(1);
    std::vector<Curve> done;
    const std::vector<Curve> curves = wanted(config, settings.integrator);
    for (Curve curve : curves) {
        const PreparedScene prepared(scene, curve.backend);
        std::vector<std::vector<Point>> seeds;
        for (int seed = 0; seed < config.seeds && !run.stop; ++seed) {
            SeedRun seed_run(prepared, settings, reference, config, run.stop);
            auto points = seed_run.points(curve.sampler, static_cast<std::uint32_t>(seed));
            if (points.empty()) break;
            seeds.push_back(std::move(points));
            curve.preparation =
                config.reading_seconds + prepared.build_seconds() + seed_run.integrator_seconds();
            curve.replaced_images = seed_run.replaced_images();
            const double part = static_cast<double>(seed + 1) / config.seeds;
            const auto before = static_cast<double>(done.size());
            run.progress((before + part) / static_cast<double>(curves.size()));
        }
        if (seeds.empty()) break;
        curve.seeds = static_cast<int>(seeds.size());
        curve.points = mean_of(seeds);
        curve.fit = fit(curve.points);
        done.push_back(std::move(curve));
        if (run.after_curve) run.after_curve(done.back());
        if (run.stop) break;
    }
    return done;
}

}  // namespace etalon::convergence
