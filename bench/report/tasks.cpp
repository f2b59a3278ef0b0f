#include "bench/report/tasks.h"

#include <ctime>

namespace etalon::bench_report {

std::string date_now() {
    const std::time_t now = std::time(nullptr);
    std::tm local = {};
    localtime_r(&now, &local);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local)};
}

/// Frames are the last: a given scene may take any time, which no other section should lack.
std::vector<Task> all_tasks(const Settings& settings) {
    std::vector<Task> all;
    for (const auto tasks : {image_tasks, convergence_tasks, foreign_tasks, speed_tasks,
                             accuracy_tasks, spd_tasks, frame_tasks}) {
        for (Task& task : tasks(settings)) all.push_back(std::move(task));
    }
    return all;
}

}  // namespace etalon::bench_report
