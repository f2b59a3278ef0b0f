#include "core/render/uniform_passes.h"

#include <algorithm>

namespace etalon {

/// Returns how many samples there will be at the deadline if they take as long as those taken since
/// its time began. As long as there are none, any number may be affordable.
std::uint32_t UniformPasses::affordable() const {
    const double part = deadline_.elapsed_fraction();
    const double done = goal_ - done_before_;
    if (!(part > 0 && done > 0)) return samples_;
    return static_cast<std::uint32_t>(std::min<double>(done_before_ + done / part, samples_));
}

void UniformPasses::restore(StateReader& bytes, std::uint64_t samples) {
    bytes(goal_);
    done_before_ = static_cast<double>(samples) / static_cast<double>(samples_of_one_);
}

std::optional<SamplingGoal> UniformPasses::next(const Film&) {
    const auto least = static_cast<std::uint32_t>(goal_ + least_of_one_);
    const std::uint32_t next =
        goal_ == 0 ? 1 : std::min({std::max(2 * goal_, least), samples_, affordable()});
    if (next <= goal_) return std::nullopt;
    goal_ = next;
    return goal();
}

SamplingGoal UniformPasses::goal() const {
    SamplingGoal goal{goal_};
    goal.of_pixel.assign(rates_.begin(), rates_.end());
    for (std::uint32_t& samples : goal.of_pixel) samples *= goal_;
    return goal;
}

bool UniformPasses::is_complete(std::uint64_t samples) const {
    return samples >= all_samples();
}

double UniformPasses::progress(std::uint64_t samples) const {
    const double part = static_cast<double>(samples) / static_cast<double>(all_samples());
    return std::max(part, deadline_.elapsed_fraction());
}

}  // namespace etalon
