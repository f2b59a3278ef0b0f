#include "bench/speed/figures.h"

#include <algorithm>

namespace etalon::speed {
namespace {

template <double Duration::*Seconds>
std::vector<double> all_of(const std::vector<Duration>& durations) {
    std::vector<double> seconds(durations.size());
    std::ranges::transform(durations, seconds.begin(), Seconds);
    return seconds;
}

template <class Figures>
std::vector<Runs> runs_of(const std::vector<Figures>& all, const std::string& tracer) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Figures& f) { return f.tracer == tracer; });
    return found == all.end() ? std::vector<Runs>() : found->by_threads;
}

template <class Figures>
void keep(std::vector<Figures>& all, int repeats) {
    for (Figures& figures : all) {
        for (Runs& runs : figures.by_threads) {
            runs.repeats.resize(static_cast<std::size_t>(repeats));
        }
    }
}

template <class Figures>
void compare(std::vector<Figures>& all) {
    const std::vector<Runs> fast = runs_of(all, baseline), robust = runs_of(all, robust_baseline);
    for (Figures& figures : all) {
        const Runs alone = figures.by_threads.front();
        for (std::size_t k = 0; k < figures.by_threads.size(); ++k) {
            Runs& runs = figures.by_threads[k];
            runs.ratio = statistics::quotient(fast.at(k).cpu(), runs.cpu());
            runs.ratio_robust = statistics::quotient(robust.at(k).cpu(), runs.cpu());
            runs.cpu_scaling = statistics::quotient(alone.cpu(), runs.cpu());
            runs.wall_scaling = statistics::quotient(alone.wall(), runs.wall());
        }
    }
}

}  // namespace

std::vector<Runs> runs_on(const std::vector<int>& threads) {
    std::vector<Runs> all(threads.size());
    for (std::size_t k = 0; k < threads.size(); ++k) all[k].threads = threads[k];
    return all;
}

std::vector<double> Runs::cpu() const {
    return all_of<&Duration::cpu>(repeats);
}

std::vector<double> Runs::wall() const {
    return all_of<&Duration::wall>(repeats);
}

void keep_repeats(std::vector<BuildFigures>& all, int repeats) {
    keep(all, repeats);
}

void keep_repeats(std::vector<RayFigures>& all, int repeats) {
    keep(all, repeats);
}

void compare_with_baselines(std::vector<BuildFigures>& all) {
    compare(all);
}

void compare_with_baselines(std::vector<RayFigures>& all) {
    compare(all);
}

}  // namespace etalon::speed
