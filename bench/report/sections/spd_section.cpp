// Section on the classic scenes of the SPD (Haines 1987, "A Proposal for Standard Graphics
// Environments").
#include <fmt/format.h>

#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

Table counts(const std::vector<SpdFigures>& all) {
    Table table{{{"scene", false},
                 {"size"},
                 {"primitives"},
                 {"camera"},
                 {"that hit"},
                 {"background"},
                 {"shadow"},
                 {"blocked"},
                 {"reflected"},
                 {"refracted"},
                 {"secondary hits"}},
                {}};
    for (const SpdFigures& s : all) {
        if (s.runs.empty()) continue;  // interrupted before its first backend
        const RayCounts& c = s.runs.front().counts;
        const double empty = static_cast<double>(c.camera - c.camera_hits);
        table.rows.push_back(
            {{s.family},
             {std::to_string(s.size)},
             {grouped(s.primitives)},
             {grouped(c.camera)},
             {grouped(c.camera_hits)},
             {fmt::format("{:.0f} %", 100 * empty / static_cast<double>(c.camera))},
             {grouped(c.shadow)},
             {grouped(c.shadow_blocked)},
             {grouped(c.reflected)},
             {grouped(c.refracted)},
             {grouped(c.secondary_hits)}});
    }
    return table;
}

bool same(const RayCounts& a, const RayCounts& b) {
    return a.camera == b.camera && a.camera_hits == b.camera_hits && a.shadow == b.shadow &&
           a.shadow_blocked == b.shadow_blocked && a.reflected == b.reflected &&
           a.refracted == b.refracted && a.secondary_hits == b.secondary_hits;
}

Bars speeds(const std::vector<SpdFigures>& all) {
    Bars bars;
    for (const SpdFigures& s : all) {
        BarGroup group{s.family, "Mrays/s", "", "counts", {}};
        for (const SpdRun& run : s.runs) {
            const double rate = 1e-6 * static_cast<double>(run.counts.total()) / run.render.cpu;
            const bool agrees = same(run.counts, s.runs.front().counts);
            group.bars.push_back({run.backend, colour_of(run.backend), rate, 0, three_digits(rate),
                                  "",
                                  agrees ? Cell{"same", Mark::good} : Cell{"other", Mark::bad}});
        }
        bars.groups.push_back(std::move(group));
    }
    return bars;
}

Table times(const std::vector<SpdFigures>& all) {
    Table table{{{"scene", false},
                 {"backend", false},
                 {"input, CPU s"},
                 {"build, CPU s"},
                 {"trace, CPU s"},
                 {"trace, s"},
                 {"rays"},
                 {"bytes"},
                 {"counts", false}},
                {}};
    for (const SpdFigures& s : all) {
        for (const SpdRun& run : s.runs) {
            const bool agrees = same(run.counts, s.runs.front().counts);
            table.rows.push_back({{s.family},
                                  {run.backend},
                                  {three_digits(s.parse)},
                                  {three_digits(run.build.cpu)},
                                  {three_digits(run.render.cpu)},
                                  {three_digits(run.render.wall)},
                                  {grouped(run.counts.total())},
                                  {grouped(run.bytes)},
                                  agrees ? Cell{"same", Mark::good} : Cell{"other", Mark::bad}});
        }
    }
    return table;
}

}  // namespace

Section spd_section(const Results& results) {
    Section section{"spd", "The classic scenes", {}, {}};
    section.prose = {
        "The subjects of the Standard Procedural Databases, in constructions of this project’s "
        "own, by the rules of that benchmark: 513 × 513 camera rays through the pixels’ corners, "
        "at "
        "most five rays in a row, a reflected ray from all glass, no shadow ray where a surface "
        "faces away from the light. The counts must be the same for every exact backend.",
        "Rays are counted and shaded here, so that these speeds are those of a whole renderer."};
    const std::vector<SpdFigures>& all = results.spd.list;
    if (all.empty()) return section;
    const std::string command = spd_command(results.settings), date = results.spd.date;
    section.figures = {
        {"Counts", "How many rays of each kind an image takes.", command, date, counts(all)},
        {"Speed", "Million rays per CPU second, all of an image on all threads; measured once.",
         command, date, speeds(all)},
        {"Times and sizes",
         "Input and build do not depend on the resolution. All were measured once.", command, date,
         times(all), true}};
    return section;
}

}  // namespace etalon::bench_report
