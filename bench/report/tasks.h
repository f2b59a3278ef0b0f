// Tasks of measurement, between which one can stop.
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
    const std::atomic<bool>& stop;         ///< set: give up soon and keep what there is
    Deadline deadline;                     ///< over: the same
    std::function<void(double)> progress;  ///< with the part done, from any thread

    bool is_over() const { return stop || deadline.is_over(); }
    /// Returns the progress of a part of the task, which reaches from `from` to `to` of the whole.
    TaskProgress part(double from, double to) const {
        return {stop, deadline,
                [tell = progress, from, to](double done) { tell(from + done * (to - from)); }};
    }
};

struct Task {
    std::string what;  ///< "soup", "hard cases of spheres"
    double seconds;    ///< on the wall, about, on two cores of 2026 with nothing else to do
    /// Adds what it measured. Says on standard error what it could not.
    std::function<void(Results& results, const TaskProgress& task_progress)> run;
};

std::vector<Task> image_tasks(const Settings& settings);
std::vector<Task> speed_tasks(const Settings& settings);
std::vector<Task> accuracy_tasks(const Settings& settings);
std::vector<Task> frame_tasks(const Settings& settings);
std::vector<Task> spd_tasks(const Settings& settings);
std::vector<Task> convergence_tasks(const Settings& settings);
/// None without a table of other programs' images.
std::vector<Task> foreign_tasks(const Settings& settings);

/// All of them, in the order in which they are to be run.
std::vector<Task> all_tasks(const Settings& settings);

/// This machine, as it is now.
Machine this_machine();

}  // namespace etalon::bench_report
