#include <algorithm>
#include <atomic>

#include "app/common/backends.h"
#include "bench/accuracy/measure_case.h"
#include "bench/report/tasks.h"
#include "core/parallel/parallel.h"

namespace etalon::bench_report {
namespace {

using accuracy::Row;
using hard::HardCase;

struct Group {
    std::string shape;
    std::vector<HardCase> cases;
};

std::vector<Group> groups() {
    std::vector<Group> groups;
    for (HardCase& c : hard::hard_cases()) {
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& g) { return g.shape == c.shape; });
        if (group == groups.end()) group = groups.insert(group, {c.shape, {}});
        group->cases.push_back(std::move(c));
    }
    return groups;
}

accuracy::Budget budget_of(const Settings& settings, const TaskProgress& task_progress) {
    accuracy::Budget budget;
    budget.rays = settings.case_rays;
    budget.seconds = settings.case_seconds;
    budget.stop = &task_progress.stop;
    return budget;
}

/// Runs cases in parallel, since a case with few rays uses only one core. Times are CPU times.
void measure(const Group& group, Results& results, const TaskProgress& task_progress) {
    std::vector<const Backend*> backends;
    for (const std::string& name : results.settings.accuracy_backends) {
        backends.push_back(find_backend(name));
    }
    const accuracy::Budget budget = budget_of(results.settings, task_progress);
    std::vector<std::vector<Row>> rows(group.cases.size());
    std::atomic<std::size_t> done{0};
    parallel_for(group.cases.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !task_progress.is_over(); ++i) {
            rows[i] = accuracy::measure(group.cases[i], backends, budget);
            task_progress.progress(static_cast<double>(++done) / static_cast<double>(rows.size()));
        }
    });
    for (std::vector<Row>& list : rows) {
        for (Row& row : list) results.rows.add(std::move(row));
    }
}

double seconds_for(const Group& group, const Settings& settings) {
    const double one = 0.02 + 5e-6 * static_cast<double>(settings.case_rays);
    return static_cast<double>(group.cases.size()) * std::min(one, settings.case_seconds);
}

}  // namespace

std::vector<Task> accuracy_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (Group& group : groups()) {
        const double seconds = seconds_for(group, settings);
        tasks.push_back(
            {"hard cases of " + group.shape, seconds,
             [group = std::move(group)](Results& results, const TaskProgress& task_progress) {
                 measure(group, results, task_progress);
             }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
