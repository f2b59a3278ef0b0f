#include "core/render/renderer.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "core/parallel/parallel.h"
#include "core/render/adaptive_passes.h"
#include "core/render/pass_errors.h"
#include "core/render/tile_renderer.h"
#include "core/render/uniform_passes.h"

namespace etalon {
namespace {

class Renderer {
  public:
    Renderer(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
             const RunControl& control)
        : settings_(settings),
          control_(control),
          tiles_(camera, integrator, settings),
          film_(tiles_.film()),
          counts_(tiles_.count()) {
        tiles_.measures_seconds = is_observed(&RenderObserver::after_tile);
        if (control.estimates_error && settings.target_error == 0) errors_.emplace(film_, settings);
    }

    Rendering run() {
        const std::unique_ptr<SamplingPasses> passes = make_passes();
        if (control_.resumed && !restore(*passes)) return {Film(film_.samples().window()), {}, {}};
        while (!stopped()) {
            if (!in_pass_) {
                std::optional<SamplingGoal> goal = passes->next(film_.samples());
                show(*passes);
                if (!goal) break;
                tiles_.goal = std::move(*goal);
            }
            render_pass(*passes);
            is_image_ = is_image_ || !in_pass_;
        }
        show(*passes);  // if it was stopped: what there is of the last pass
        if (!passes->is_complete(samples_done_)) keep(*passes);
        return finished(*passes);
    }

  private:
    /// Returns whether to stop. However short the time is, an image has one sample of each pixel,
    /// and one that is resumed gets some more.
    bool stopped() const {
        return (control_.stop != nullptr && control_.stop->load()) || control_.stop_at.is_over() ||
               (control_.dealer != nullptr && control_.dealer->has_failed()) ||
               (is_image_ && samples_done_ > samples_resumed_ && control_.deadline.is_over());
    }

    /// The film's counts tell what is done in the pass.
    template <class Bytes>
    void transfer(Bytes& bytes) {
        film_.transfer(bytes);
        tiles_.goal.transfer(bytes);
        bytes(in_pass_);
        bytes(is_image_);
        bytes(shown_);
    }

    void keep(SamplingPasses& passes) {
        if (!control_.keeper) return;
        control_.keeper->keep([&](StateWriter& bytes) {
            transfer(bytes);
            bytes(ray_counts());
            bytes(samples_dropped_.load());
            passes.save(bytes);
        });
    }

    bool restore(SamplingPasses& passes) {
        StateReader& bytes = *control_.resumed;
        transfer(bytes);
        bytes.expect(is_goal_possible());
        bytes(resumed_counts_);
        std::uint64_t dropped = 0;
        bytes(dropped);
        samples_dropped_ = dropped;
        samples_done_ = samples_resumed_ = film_.samples().total_count();
        passes.restore(bytes, samples_resumed_);
        shown_ = 0;  // the observers of this process have seen nothing
        return !bytes.failed();
    }

    /// Returns whether the goal is one of this image, of at most the samples that it is to have.
    bool is_goal_possible() const {
        const std::size_t pixels = film_.samples().size();
        const SampleRates& rates = film_.rates();
        if (const auto& goals = tiles_.goal.of_pixel; !goals.empty() && goals.size() != pixels) {
            return false;
        }
        if (!rates.empty() && rates.size() != pixels) return false;
        const auto [first, last] = settings_.sample_range();
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const std::uint64_t rate = rates.empty() ? 1 : rates[pixel];
            if (tiles_.goal.of(pixel) > (last - first) * rate) return false;
        }
        return true;
    }

    RayCounts ray_counts() const {
        RayCounts sum = resumed_counts_;
        for (const RayCounts& c : counts_) sum += c;
        return sum;
    }

    /// Passes the film to the observers, if there is anything new in it.
    void show(const SamplingPasses& passes) {
        if (is_observed(&RenderObserver::after_pass) && shown_ < samples_done_) {
            if (errors_) errors_->look();
            const auto error = errors_ ? errors_->expected() : passes.expected_error();
            tiles_.with_image([&](const Film& film) {
                const double samples = static_cast<double>(samples_done_) / sampled_pixels(film);
                tell(&RenderObserver::after_pass, RenderedPass{film, error, samples});
            });
        }
        shown_ = samples_done_;
    }

    template <class Function>
    bool is_observed(Function RenderObserver::*function) const {
        return std::ranges::any_of(control_.observers,
                                   [&](const RenderObserver& o) { return bool(o.*function); });
    }

    /// Calls a function of all observers that have it.
    template <class Function, class Event>
    void tell(Function RenderObserver::*function, const Event& event) const {
        for (const RenderObserver& observer : control_.observers) {
            if (observer.*function) (observer.*function)(event);
        }
    }

    std::unique_ptr<SamplingPasses> make_passes() const {
        const auto [first, last] = settings_.sample_range();
        if (settings_.target_error > 0) {
            return std::make_unique<AdaptivePasses>(film_, settings_, last);
        }
        return std::make_unique<UniformPasses>(last - first, film_.samples().size(),
                                               control_.deadline, film_.rates(), least_of_pass());
    }

    /// Returns how many samples of all pixels are worth a pass. Each pass has its costs, so they
    /// are some seconds' samples if no one can see, or depends on, the image between passes.
    std::uint64_t least_of_pass() const {
        constexpr std::uint64_t some_seconds = 1 << 22;
        const bool is_watched =
            errors_ || control_.dealer != nullptr || control_.deadline.is_limited() ||
            is_observed(&RenderObserver::after_tile) || is_observed(&RenderObserver::after_pass);
        return is_watched ? 0 : some_seconds;
    }

    /// Returns the number of pixels that are sampled for an image: with a filter also some beyond
    /// it.
    double sampled_pixels(const Film& image) const {
        return static_cast<double>(film_.is_filtered() ? film_.samples().size() : image.size());
    }

    Rendering finished(const SamplingPasses& passes) {
        if (control_.take_film) {
            control_.take_film([&](StateWriter& bytes) { film_.transfer(bytes); });
        }
        Rendering result{tiles_.take_image(), ray_counts(), resumed_counts_};
        const double pixels = sampled_pixels(result.film);
        result.samples = static_cast<double>(samples_done_) / pixels;
        result.resumed_samples = static_cast<double>(samples_resumed_) / pixels;
        result.dropped_samples = samples_dropped_;
        result.expected_error = passes.expected_error();
        result.complete = passes.is_complete(samples_done_);
        result.misses_target = passes.misses_target();
        return result;
    }

    /// Renders the pass until a stop; meanwhile the state is saved when it is due.
    void render_pass(SamplingPasses& passes) {
        in_pass_ = true;
        while (in_pass_ && !stopped()) {
            std::atomic<bool> paused = false;
            const auto interrupted = [&] {
                if (control_.keeper && control_.keeper->is_due()) paused = true;
                return paused || stopped();
            };
            render_tiles(interrupted, passes);
            in_pass_ = paused || stopped();
            if (paused) keep(passes);
        }
    }

    void render_tiles(const std::function<bool()>& interrupted, const SamplingPasses& passes) {
        std::vector<std::size_t> tiles = tiles_.unfinished_tiles();
        const auto render = [&](std::size_t tile) {
            add_result(tile, tiles_.render(tile, interrupted), passes);
        };
        if (control_.dealer) {
            return control_.dealer->deal(dealt(std::move(tiles), interrupted, render, passes));
        }
        parallel_for(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !interrupted(); ++i) render(tiles[i]);
        });
    }

    template <class Render>
    DealtPass dealt(std::vector<std::size_t> tiles, const std::function<bool()>& interrupted,
                    const Render& render, const SamplingPasses& passes) {
        return {std::move(tiles), render,
                [&](std::size_t tile, StateWriter& task) { tiles_.transfer_task(tile, task); },
                [&](std::size_t tile, StateReader& result) { read_result(tile, result, passes); },
                interrupted};
    }

    void read_result(std::size_t tile, StateReader& bytes, const SamplingPasses& passes) {
        TileResult result;
        bytes(result);
        tiles_.transfer_film(tile, bytes);
        if (!bytes.failed()) add_result(tile, result, passes);
    }

    void add_result(std::size_t tile, const TileResult& result, const SamplingPasses& passes) {
        counts_[tile] += result.counts;
        samples_dropped_ += result.dropped;
        const std::uint64_t total = samples_done_.fetch_add(result.samples) + result.samples;
        tell(&RenderObserver::after_tile,
             RenderedTile{film_.samples(), tiles_.tile(tile), result.seconds});
        tell(&RenderObserver::progress, passes.progress(total));
    }

    const RenderSettings& settings_;
    const RunControl& control_;
    TileRenderer tiles_;
    ImageFilm& film_;
    std::vector<RayCounts> counts_;  ///< for each tile; one thread at a time adds to it
    RayCounts resumed_counts_;
    bool in_pass_ = false;              ///< the goal is not reached
    bool is_image_ = false;             ///< the first pass is complete
    std::optional<PassErrors> errors_;  ///< if the passes do not estimate them
    std::atomic<std::uint64_t> samples_done_ = 0;
    std::atomic<std::uint64_t> samples_dropped_ = 0;
    std::uint64_t samples_resumed_ = 0, shown_ = 0;
};

}  // namespace

Rendering render(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
                 const RunControl& control) {
    return Renderer(camera, integrator, settings, control).run();
}

void render_dealt_tiles(const Camera& camera, const Integrator& integrator,
                        const RenderSettings& settings,
                        const std::function<void(const TileTask&)>& serve) {
    TileRenderer tiles(camera, integrator, settings);
    tiles.goal.of_pixel.resize(tiles.film().samples().size());  // for the goals of any pass
    serve([&](std::size_t tile, StateReader& task, StateWriter& result, const auto& stopped) {
        tiles.transfer_task(tile, task);
        if (task.failed()) return;
        result(tiles.render(tile, stopped));
        tiles.transfer_film(tile, result);
    });
}

}  // namespace etalon
