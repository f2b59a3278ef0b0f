#include "bench/accuracy/timed_tracers.h"

#include <optional>

#include "core/base/clocks.h"
#include "core/intersect/backend_roles.h"

namespace etalon::accuracy {
namespace {

constexpr std::uint64_t occlusion_every = 4;  ///< one block in so many also tests occlusion

void count_contradictions(const TracerEntry& entry, const RayBlock& block,
                          const std::vector<Answer>& answers, ErrorStats& stats) {
    if (!entry.refined) return;  // a textbook kernel returns only t
    std::vector<char> occluded(answers.size());
    entry.tracer->occluded(block, occluded);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const bool hit = answers[i].primitive != no_index;
        stats.contradictions += hit != (occluded[i] != 0);
    }
}

}  // namespace

TimedTracers::TimedTracers(const hard::HardCase& hard_case, const hard::CaseSetup& setup,
                           const std::vector<const Backend*>& backends, const Budget& budget)
    : items_(setup.scene.geometry.item_count()), most_tests_(budget.tests) {
    for (const Backend* b : backends) {
        if (b->has_own_kernels && !b->has_own_kernels(setup.scene.geometry)) continue;
        enter(backend_tracer(*b, setup.scene), b->exact, true);
    }
    if (!budget.textbooks) return;
    if (auto kernel = kernel_tracer(setup.scene)) enter(std::move(kernel), true, true);
    if (hard_case.criterion != hard::Criterion::oracle) return;
    for (auto& textbook : textbook_tracers(setup.scene)) {
        enter(std::move(textbook), false, false);
    }
}

void TimedTracers::enter(std::unique_ptr<Tracer> tracer, bool exact, bool refined) {
    entries_.push_back({std::move(tracer), exact, refined});
}

/// The reference backend tests every ray against every item, until it has used up its tests.
bool TimedTracers::takes_part(const TracerEntry& entry, std::uint64_t block_number) const {
    const std::uint64_t tests = block_number * block_size * items_;
    return entry.tracer->name() != reference_backend || tests < most_tests_;
}

/// Alternates between the first and the last tracer as the first to run, so that drift affects
/// all equally.
std::vector<std::vector<Answer>> TimedTracers::trace(const RayBlock& block,
                                                     std::uint64_t block_number,
                                                     std::vector<TracerResult>& results) const {
    const std::size_t count = entries_.size();
    std::vector<std::vector<Answer>> answers(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = block_number % 2 == 0 ? i : count - 1 - i;
        if (!takes_part(entries_[k], block_number)) continue;
        answers[k].resize(block.rays.size(), missed);
        const double start = thread_cpu_seconds();
        entries_[k].tracer->closest(block, answers[k]);
        const double seconds = thread_cpu_seconds() - start;
        const auto rays = static_cast<double>(block.rays.size());
        results[k].nanoseconds.push_back(1e9 * seconds / rays);
        if (block_number % occlusion_every != 0) continue;
        count_contradictions(entries_[k], block, answers[k], results[k].stats);
    }
    count_deviations(answers, results);
    return answers;
}

void TimedTracers::count_deviations(const std::vector<std::vector<Answer>>& answers,
                                    std::vector<TracerResult>& results) const {
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        if (!entries_[k].exact || answers[k].empty()) continue;
        if (!first) first = k;
        for (std::size_t i = 0; i < answers[k].size(); ++i) {
            const Answer &a = answers[k][i], &b = answers[*first][i];
            results[k].stats.deviations +=
                a.primitive != b.primitive || a.instance != b.instance || a.t != b.t;
        }
    }
}

}  // namespace etalon::accuracy
