#include "bench/report/sections/sections.h"

#include <fmt/format.h>

#include "bench/report/command_lines.h"

namespace etalon::bench_report {
namespace {

constexpr const char* introduction =
    "Etalon renders scenes through interchangeable intersection backends, its own and Embree’s, so "
    "that each checks the speed and the correctness of the others. What follows are the speeds of "
    "these backends, the errors beside them, and where the time of whole images goes, all measured "
    "on "
    "the machine below by the commands under each figure.";

/// Share of the cores in use at the start above which the report warns that the machine was not
/// idle.
constexpr double busy = 0.2;

std::string warning_of(const Machine& machine) {
    if (machine.load <= busy * machine.cores) return {};
    return fmt::format(
        "The machine was busy when this began: a load of {:.2f} on {} cores. CPU times suffer from "
        "what shares the caches, and wall times from whatever ran.",
        machine.load, machine.cores);
}

/// A section, and whether a report has it.
struct Maker {
    Section (*make)(const Results&);
    bool (*is_wanted)(const Results&) = [](const Results&) { return true; };
};

bool has_foreign_table(const Results& results) {
    return !results.settings.foreign_table.empty();
}

constexpr Maker makers[] = {
    {machine_section}, {speed_section},       {builds_section},
    {pareto_section},  {convergence_section}, {foreign_section, has_foreign_table},
    {images_section},  {frames_section},      {hard_cases_section},
    {spd_section},
};

}  // namespace

Page page_of(const Results& results) {
    Page page;
    page.title = "Etalon’s report";
    page.subtitle =
        fmt::format("{}, {}, Etalon {}, the {} report", results.begun, results.machine.processor,
                    results.machine.version, results.settings.name);
    page.introduction = introduction;
    page.missing = results.missing;
    page.warning = warning_of(results.machine);
    page.summary = summary(results);
    for (const auto& [make, is_wanted] : makers) {
        if (is_wanted(results)) page.sections.push_back(make(results));
    }
    page.command = command_of(results.settings);
    return page;
}

}  // namespace etalon::bench_report
