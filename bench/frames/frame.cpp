#include "bench/frames/frame.h"

#include <algorithm>
#include <iterator>

#include "app/common/backends.h"
#include "app/common/stopwatch.h"
#include "bench/frames/fill_film.h"
#include "bench/frames/process_start.h"
#include "bench/statistics/statistics.h"
#include "core/image/io.h"
#include "core/integrators/integrators.h"

namespace etalon::frames {
namespace {

/// Returns black without tracing a ray: the time that remains is that of camera rays and film.
class Black : public Integrator {
  public:
    explicit Black(const Integrator& replaced) : uses_sources_(replaced.uses_sources()) {}

    bool uses_sources() const override { return uses_sources_; }

    void radiance(const CameraSamples&, std::span<Color> colors, RayCounts&) const override {
        std::ranges::fill(colors, Color(0.0F));
    }

  private:
    bool uses_sources_;
};

/// Returns the seconds of adding the samples of an image to its film.
double film_seconds(const RenderSettings& settings, const Film& image) {
    ImageFilm film(settings.window(), settings);
    return fill_film(film, image);
}

RenderedImage image_of(const Film& film) {
    RenderedImage image;
    image.window = film.window();
    image.width = image.window.max.x + 1;
    image.height = image.window.max.y + 1;
    image.pixels = film.pixels();
    return image;
}

}  // namespace

Frame::Frame(const Scene& scene, const RenderSettings& settings, const FrameConfig& config,
             std::uint64_t rays_to_record)
    : scene_(scene),
      settings_(settings),
      control_{.stop = config.stop, .stop_at = config.deadline},
      backend_(built()),
      intersector_(scene.geometry, *backend_, chosen_backend(settings_).exact) {
    Stopwatch cold;
    integrator_ = made(intersector_, problems_);
    first_.emplace(rendered(*integrator_));
    first_seconds_ = cold.lap().cpu;
    std::ranges::move(integrator_->late_problems(), std::back_inserter(problems_));
    recorded_.emplace(intersector_, 1 + first_->counts.total() / rays_to_record);
    std::vector<std::string> same_problems;
    rendered(*made(*recorded_, same_problems));
}

std::string Frame::measure_again(const FrameConfig& config) {
    Repeat r;
    Stopwatch watch;
    built();
    r.build = watch.lap().cpu;
    rendered(*integrator_);
    r.render = watch.lap().cpu;
    r.intersection = recorded_->replay();
    r.film = film_seconds(settings_, first_->film);
    watch.lap();
    rendered(Black(*integrator_));
    r.camera = watch.lap().cpu - r.film;
    const RenderedImage image = image_of(first_->film);
    watch.lap();
    std::string error = write_image(config.image, image);
    r.write = watch.lap().cpu;
    if (!config.is_over()) repeats_.push_back(r);
    return error;
}

FrameFigures Frame::figures() const {
    FrameFigures f = medians();
    f.repeats = static_cast<int>(repeats_.size());
    f.start = seconds_before_main();
    f.images = std::max(0.0, first_seconds_ - f.render);
    f.backend = chosen_backend(settings_).name;
    f.width = settings_.resolution.x;
    f.height = settings_.resolution.y;
    f.samples = static_cast<int>(first_->film.total_count() / first_->film.size());
    f.rays = first_->counts.total();
    return f;
}

FrameFigures Frame::medians() const {
    const auto median_of = [&](double Repeat::*part) {
        std::vector<double> values;
        for (const Repeat& repeat : repeats_) values.push_back(repeat.*part);
        return statistics::median(values);
    };
    FrameFigures f;
    f.build = median_of(&Repeat::build);
    f.render = median_of(&Repeat::render);
    f.camera = median_of(&Repeat::camera);
    f.intersection = median_of(&Repeat::intersection);
    f.film = median_of(&Repeat::film);
    f.write = median_of(&Repeat::write);
    return f;
}

std::unique_ptr<Intersector> Frame::built() const {
    return chosen_backend(settings_).build(scene_.geometry);
}

std::unique_ptr<Integrator> Frame::made(const BatchIntersector& intersector,
                                        std::vector<std::string>& problems) const {
    return find_integrator(settings_.integrator)->make(scene_, intersector, settings_, problems);
}

Rendering Frame::rendered(const Integrator& integrator) const {
    return render(scene_.camera, integrator, settings_, control_);
}

}  // namespace etalon::frames
