// Section on whole frames: the time of each stage.
#include <fmt/format.h>

#include "bench/frames/stages.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using frames::FrameFigures;
using frames::Stage;

struct Group {
    FrameOrigin origin;
    const char *title, *about;
};

constexpr Group groups[] = {
    {FrameOrigin::given, "The scenes of the command line", "Scene files that were asked for."},
    {FrameOrigin::shipped, "Scenes of this project", "Scenes that come with Etalon."},
    {FrameOrigin::family, "The classic scenes", "Scenes that etalon-scenes makes."},
};

std::vector<Column> columns() {
    std::vector<Column> all = {{"scene", false}, {"backend", false}, {"size"}, {"spp"}};
    all.push_back({"overhead"});
    all.push_back({"ns a ray"});
    for (const Stage& stage : frames::stages()) all.push_back({stage.key});
    return all;
}

std::vector<Cell> row_of(const FrameFigures& f) {
    std::vector<Cell> row{{f.scene},
                          {f.backend},
                          {fmt::format("{} × {}", f.width, f.height)},
                          {std::to_string(f.samples)}};
    row.push_back({three_digits(f.overhead())});
    row.push_back({three_digits(f.nanoseconds())});
    for (const Stage& stage : frames::stages()) {
        row.push_back({three_digits(1e3 * stage.seconds(f))});
    }
    return row;
}

Table table_of(const std::vector<MeasuredFrame>& all, FrameOrigin origin) {
    Table table{columns(), {}};
    for (const MeasuredFrame& frame : all) {
        if (frame.origin == origin) table.rows.push_back(row_of(frame.figures));
    }
    return table;
}

/// "start is ...; load is ...", of all stages.
std::string legend() {
    std::string text;
    for (const Stage& stage : frames::stages()) {
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", stage.key, stage.meaning);
    }
    return text + ".";
}

}  // namespace

Section frames_section(const Results& results) {
    Section section{"frames", "Whole frames", {}, {}};
    section.prose = {
        "An image is more than its intersections: camera rays have to be made, surfaces and lights "
        "evaluated, samples added up. The overhead is the time of the rendering over the time that "
        "the intersector alone takes for the same rays; 1 would be a renderer that does nothing "
        "else.",
        "The columns of the tables: " + legend()};
    for (const Group& group : groups) {
        Table table = table_of(results.frames.list, group.origin);
        if (table.rows.empty()) continue;
        section.figures.push_back({group.title,
                                   fmt::format("{} CPU milliseconds of one thread.", group.about),
                                   frames_command(results.settings, group.origin),
                                   results.frames.date, std::move(table)});
    }
    return section;
}

}  // namespace etalon::bench_report
