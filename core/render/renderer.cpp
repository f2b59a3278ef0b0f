#include "core/render/renderer.h"

#include <time.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/parallel/spares.h"
#include "core/render/adaptive_passes.h"
#include "core/render/camera_sampler.h"
#include "core/render/image_film.h"
#include "core/render/pass_errors.h"
#include "core/render/sample_batch.h"
#include "core/render/tiles.h"
#include "core/render/uniform_passes.h"

namespace etalon {
namespace {

/// Returns the processor time of this thread in seconds.
double thread_seconds() {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Result of rendering a tile, beside its film.
struct TileResult {
    RayCounts counts;
    std::uint64_t samples = 0, dropped = 0;
    double seconds = 0;  ///< of processor time
};

class Renderer {
  public:
    Renderer(const Camera& camera, const Integrator& integrator, const RenderSettings& settings,
             const RunControl& control)
        : settings_(settings),
          control_(control),
          rays_(camera, settings),
          integrator_(integrator),
          film_(rays_.sampled(settings.window()), settings),
          tiles_(film_.tiles()),
          counts_(tiles_.size()) {
        if (settings.target_error > 0) return;
        if (control.estimates_error) errors_.emplace(film_, settings);
        film_.set_rates(sample_rates(camera, integrator, settings, film_.samples().window()));
    }

    /// Renders a tile for another process.
    void do_task(std::size_t tile, StateReader& task, StateWriter& result,
                 const std::function<bool()>& interrupted) {
        transfer_task(tile, task);
        if (task.failed()) return;
        const TileResult there = render_tile(tile, interrupted);
        result(there);
        film_.transfer(result, tiles_[tile]);
    }

    /// Prepares for tasks of any pass.
    void expect_tasks() { goal_.of_pixel.resize(film_.samples().size()); }

    Rendering run() {
        const std::unique_ptr<SamplingPasses> passes = make_passes();
        if (control_.resumed && !restore(*passes)) return {Film(film_.samples().window()), {}, {}};
        while (!stopped()) {
            if (!in_pass_) {
                std::optional<SamplingGoal> goal = passes->next(film_.samples());
                show(*passes);
                if (!goal) break;
                goal_ = std::move(*goal);
            }
            render_pass(*passes);
            is_image_ = is_image_ || !in_pass_;
        }
        show(*passes);  // if it was stopped: what there is of the last pass
        if (!passes->is_complete(samples_done_)) keep(*passes);
        return finished(*passes);
    }

  private:
    /// Returns whether to stop. However short the time is, an image has one sample of each pixel.
    bool stopped() const {
        return (control_.stop != nullptr && control_.stop->load()) ||
               (control_.dealer != nullptr && control_.dealer->has_failed()) ||
               (is_image_ && control_.deadline.is_over());
    }

    /// The film's counts tell what is done in the pass: a pixel has all samples of the pass or
    /// none.
    template <class Bytes>
    void transfer(Bytes& bytes) {
        film_.transfer(bytes);
        goal_.transfer(bytes);
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
        bytes(resumed_counts_);
        std::uint64_t dropped = 0;
        bytes(dropped);
        samples_dropped_ = dropped;
        passes.restore(bytes);
        samples_done_ = samples_resumed_ = film_.samples().total_count();
        return !bytes.failed();
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
            const auto tell_film = [&](const Film& film) {
                tell(&RenderObserver::after_pass, RenderedPass{film, error});
            };
            if (film_.is_filtered()) {
                tell_film(film_.filtered());
            } else if (rays_.shares_corners()) {
                tell_film(film_.samples().cells());
            } else {
                tell_film(film_.samples());
            }
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
                                               control_.deadline, film_.rates());
    }

    Rendering finished(const SamplingPasses& passes) {
        if (control_.take_film) {
            control_.take_film([&](StateWriter& bytes) { film_.transfer(bytes); });
        }
        const auto sampled = static_cast<double>(film_.samples().size());
        Rendering result{image(), ray_counts(), resumed_counts_};
        const double pixels =
            film_.is_filtered() ? sampled : static_cast<double>(result.film.size());
        result.samples = static_cast<double>(samples_done_) / pixels;
        result.resumed_samples = static_cast<double>(samples_resumed_) / pixels;
        result.dropped_samples = samples_dropped_;
        result.expected_error = passes.expected_error();
        result.complete = passes.is_complete(samples_done_);
        return result;
    }

    Film image() {
        if (film_.is_filtered()) return film_.filtered();
        return rays_.shares_corners() ? film_.samples().cells() : film_.take_samples();
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

    /// Returns the numbers of the tiles that lack samples.
    std::vector<std::size_t> unfinished_tiles() const {
        std::vector<std::size_t> unfinished;
        for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
            bool lacks_samples = false;
            for_each_pixel(tiles_[tile], [&](int x, int y) {
                const std::size_t pixel = film_.samples().index(x, y);
                lacks_samples |= film_.samples().counts()[pixel] < goal_.of(pixel);
            });
            if (lacks_samples) unfinished.push_back(tile);
        }
        return unfinished;
    }

    template <class Interrupted>
    void render_tiles(const Interrupted& interrupted, const SamplingPasses& passes) {
        std::vector<std::size_t> tiles = unfinished_tiles();
        const auto render = [&](std::size_t tile) {
            add_result(tile, render_tile(tile, interrupted), passes);
        };
        if (control_.dealer) {
            return control_.dealer->deal(dealt(std::move(tiles), interrupted, render, passes));
        }
        parallel_for(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !interrupted(); ++i) render(tiles[i]);
        });
    }

    template <class Interrupted, class Render>
    DealtPass dealt(std::vector<std::size_t> tiles, const Interrupted& interrupted,
                    const Render& render, const SamplingPasses& passes) {
        return {std::move(tiles),
                render,
                [&](std::size_t tile, StateWriter& task) { transfer_task(tile, task); },
                [&](std::size_t tile, StateReader& result) { read_result(tile, result, passes); },
                interrupted,
                [&] { return stopped(); }};
    }

    /// Transfers what another process needs to render a tile: the goals of its pixels, and the
    /// contents of its film.
    template <class Bytes>
    void transfer_task(std::size_t tile, Bytes& bytes) {
        for_each_pixel(tiles_[tile], [&](int x, int y) {
            const std::size_t pixel = film_.samples().index(x, y);
            std::uint32_t goal = goal_.of(pixel);
            bytes(goal);
            if (!goal_.of_pixel.empty()) goal_.of_pixel[pixel] = goal;
        });
        film_.transfer(bytes, tiles_[tile]);
    }

    void read_result(std::size_t tile, StateReader& bytes, const SamplingPasses& passes) {
        TileResult result;
        bytes(result);
        film_.transfer(bytes, tiles_[tile]);
        if (!bytes.failed()) add_result(tile, result, passes);
    }

    template <class Interrupted>
    TileResult render_tile(std::size_t tile, const Interrupted& interrupted) {
        const double start = thread_seconds();
        TileResult result;
        const auto loan = batches_.lend(rays_, integrator_, film_);
        SampleBatch& batch = *loan;
        batch.begin(result.counts);
        for_each_pixel(tiles_[tile], interrupted, [&](int x, int y) { add_pixel(x, y, batch); });
        batch.finish();
        result.samples = batch.done();
        result.dropped = batch.dropped();
        result.seconds = thread_seconds() - start;
        return result;
    }

    void add_result(std::size_t tile, const TileResult& result, const SamplingPasses& passes) {
        counts_[tile] += result.counts;
        samples_dropped_ += result.dropped;
        const std::uint64_t total = samples_done_.fetch_add(result.samples) + result.samples;
        tell(&RenderObserver::after_tile,
             RenderedTile{film_.samples(), tiles_[tile], result.seconds});
        tell(&RenderObserver::progress, passes.progress(total));
    }

    /// Returns the number of the pixel's first sample in this part of the image.
    std::uint32_t first_sample(std::size_t pixel) const {
        const SampleRates& rates = film_.rates();
        return settings_.sample_range().first * (rates.empty() ? 1U : rates[pixel]);
    }

    /// Adds the samples that the pixel lacks to the batch.
    void add_pixel(int x, int y, SampleBatch& batch) const {
        const std::size_t pixel = film_.samples().index(x, y);
        const std::uint32_t first = first_sample(pixel);
        std::uint32_t next = first + film_.samples().counts()[pixel];
        for (const std::uint32_t last = first + goal_.of(pixel); next < last;) {
            const std::uint32_t end = std::min(last, next + batch.room());
            batch.add(x, y, next, end);
            next = end;
        }
    }

    const RenderSettings& settings_;
    const RunControl& control_;
    CameraSampler rays_;
    const Integrator& integrator_;
    ImageFilm film_;
    Spares<SampleBatch> batches_;
    std::vector<Imath::Box2i> tiles_;
    std::vector<RayCounts> counts_;  ///< for each tile; one thread at a time adds to it
    RayCounts resumed_counts_;
    SamplingGoal goal_;
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
    const RunControl control;
    Renderer renderer(camera, integrator, settings, control);
    renderer.expect_tasks();
    serve([&](std::size_t tile, StateReader& task, StateWriter& result, const auto& stopped) {
        renderer.do_task(tile, task, result, stopped);
    });
}

}  // namespace etalon
