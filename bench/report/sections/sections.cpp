#include "bench/report/sections/sections.h"

#include <fmt/format.h>

#include "bench/report/command_lines.h"

namespace etalon::bench_report {
namespace {

constexpr Section (*makers[])(const Results&) = {
    machine_section, speed_section,  builds_section,     pareto_section, convergence_section,
    images_section,  frames_section, hard_cases_section, spd_section,
};

}  // namespace

Page page_of(const Results& results) {
    Page page;
    page.title = "Etalon’s report";
    page.subtitle =
        fmt::format("{}, {}, Etalon {}, the {} report", results.begun, results.machine.processor,
                    results.machine.version, results.settings.name);
    page.missing = results.missing;
    page.summary = summary(results);
    for (const auto make : makers) page.sections.push_back(make(results));
    page.command = command_of(results.settings);
    return page;
}

}  // namespace etalon::bench_report
