#include "core/render/adaptive_passes.h"

#include <algorithm>
#include <cmath>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

/// Number of samples of every pixel, within the reach of its filter, before any pixel is preferred
/// and before the estimate of the error is believed: that of four was half the error.
constexpr double fewest = 8;

/// Relative accuracy of the expected error.
constexpr double tolerance = 0.03;

/// A pass adds at most this fraction of the existing samples, and goes at most this fraction of the
/// way to the target error; then the errors are estimated anew.
constexpr double most_samples = 0.5, most_of_the_way = 0.7;

/// Largest ratio of the numbers of samples of two pixels. So what a few samples missed, such as a
/// small light or a thin object, is found in the end, whatever they said of the error.
constexpr std::uint32_t most_to_fewest = 64;

double fewest_with(const PixelFilter& filter) {
    const auto reach = [&](int axis) { return std::min(1.0, 2 * filter.radius[axis]); };
    return fewest / (reach(0) * reach(1));
}

}  // namespace

AdaptivePasses::AdaptivePasses(const ImageFilm& image, const RenderSettings& settings,
                               std::uint32_t samples)
    : errors_(image, settings),
      error_(settings.target_error),
      fewest_(fewest_with(settings.filter)),
      samples_(samples) {}

std::optional<SamplingGoal> AdaptivePasses::next(const Film& film) {
    errors_.look();
    expected_ = errors_.estimate().total();
    std::optional<SamplingGoal> goal = plan(film);
    is_complete_ = !goal;
    return goal;
}

std::optional<SamplingGoal> AdaptivePasses::plan(const Film& film) {
    if (knows_too_little()) return SamplingGoal{of_all_ = std::max(1U, 2 * of_all_)};
    if (is_enough()) return std::nullopt;
    SamplingGoal goal = worthwhile(film);
    if (goal.of_pixel != film.counts()) return goal;
    // None can be doubled; what is left are the samples to a number that is no power of two.
    const bool is_full = *std::ranges::min_element(film.counts()) >= samples_;
    return is_full ? std::nullopt : std::optional(SamplingGoal{samples_});
}

std::optional<double> AdaptivePasses::expected_error() const {
    return errors_.estimate().exists() ? std::optional(expected_) : std::nullopt;
}

bool AdaptivePasses::misses_target() const {
    return is_complete_ && !is_enough();
}

bool AdaptivePasses::is_enough() const {
    return errors_.estimate().exists() && expected_ <= (1 + tolerance) * error_;
}

/// Returns whether too little is known to choose pixels, or to end. False if twice the samples for
/// all would be more than was asked for.
bool AdaptivePasses::knows_too_little() const {
    return of_all_ < fewest_ && 2 * of_all_ <= samples_;
}

/// Returns the candidates, the best first.
std::vector<AdaptivePasses::Candidate> AdaptivePasses::candidates(const Film& film) const {
    const ErrorEstimate& estimate = errors_.estimate();
    std::vector<Candidate> result(film.size());
    parallel_for(film.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int x = static_cast<int>(i) % film.width();
            const int y = static_cast<int>(i) / film.width();
            const double falls_by = 1 - std::exp2(-estimate.rate(x, y));
            result[i] = {estimate.by_neighbours(x, y) * falls_by / film.counts()[i],
                         static_cast<std::uint32_t>(i)};
        }
    });
    std::erase_if(result,
                  [&](const Candidate& c) { return 2 * film.counts()[c.pixel] > samples_; });
    std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
        return a.gain != b.gain ? a.gain > b.gain : a.pixel < b.pixel;
    });
    return result;
}

SamplingGoal AdaptivePasses::worthwhile(const Film& film) const {
    SamplingGoal goal{0, film.counts()};
    const std::uint32_t most = *std::max_element(goal.of_pixel.begin(), goal.of_pixel.end());
    const auto pixels = static_cast<double>(film.size());
    double to_gain = most_of_the_way * (expected_ - error_) * pixels;
    double budget = most_samples * static_cast<double>(film.total_count());
    for (const Candidate& c : candidates(film)) {
        std::uint32_t& count = goal.of_pixel[c.pixel];
        const bool lags = count * most_to_fewest <= most;
        if (!lags && (to_gain <= 0 || budget <= 0)) continue;
        to_gain -= c.gain * count;
        budget -= count;
        count *= 2;
    }
    return goal;
}

double AdaptivePasses::progress(std::uint64_t) const {
    return expected_ > 0 ? std::min(1.0, error_ / expected_) : 0;
}

}  // namespace etalon
