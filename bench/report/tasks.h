// Measurement tasks; a run can be stopped between them.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "bench/report/measured_results.h"
#include "core/render/deadline.h"

namespace etalon::bench_report {

/// Stop flag, deadline and progress callback of a task.
struct TaskProgress {
    const std::atomic<bool>& stop;         ///< if set, stop soon and keep results
    Deadline deadline;                     ///< likewise if it is over
    std::function<void(double)> progress;  ///< called with the fraction done, from any thread

    bool is_over() const { return stop || deadline.is_over(); }
    /// Returns the progress of a part of the task, from fraction `from` to `to` of the whole.
    TaskProgress part(double from, double to) const {
        return {stop, deadline,
                [tell = progress, from, to](double done) { tell(from + done * (to - from)); }};
    }
};

struct Task {
    std::string what;  ///< "soup", "hard cases of spheres"
    double seconds;    ///< approximate wall time on two idle cores of 2026
    /// Adds its results. Reports on standard error what it could not measure.
    std::function<void(Results& results, const TaskProgress& task_progress)> run;
};

std::vector<Task> image_tasks(const Settings& settings);
std::vector<Task> speed_tasks(const Settings& settings);
std::vector<Task> accuracy_tasks(const Settings& settings);
std::vector<Task> frame_tasks(const Settings& settings);
std::vector<Task> spd_tasks(const Settings& settings);
std::vector<Task> convergence_tasks(const Settings& settings);
/// Returns no tasks without a table of other programs' images.
std::vector<Task> foreign_tasks(const Settings& settings);

/// Returns all tasks, in the order in which they are to be run.
std::vector<Task> all_tasks(const Settings& settings);

/// Returns the current state of this machine.
Machine this_machine();

}  // namespace etalon::bench_report
