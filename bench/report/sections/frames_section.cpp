// Where the time of whole frames goes.
#include <fmt/format.h>

#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

Table parts(const std::vector<frames::FrameFigures>& all) {
    Table table{{{"scene", false},
                 {"backend", false},
                 {"size"},
                 {"spp"},
                 {"load"},
                 {"build"},
                 {"images"},
                 {"camera"},
                 {"intersection"},
                 {"shading"},
                 {"film"},
                 {"write"},
                 {"ns a ray"},
                 {"overhead"}},
                {}};
    for (const frames::FrameFigures& f : all) {
        std::vector<Cell> row{{f.scene},
                              {f.backend},
                              {fmt::format("{} × {}", f.width, f.height)},
                              {std::to_string(f.samples)}};
        for (const double seconds :
             {f.load, f.build, f.images, f.camera, f.intersection, f.shading(), f.film, f.write}) {
            row.push_back({three_digits(seconds)});
        }
        row.push_back({three_digits(1e9 * f.render / static_cast<double>(f.rays))});
        row.push_back({three_digits(f.overhead())});
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

Section frames_section(const Results& results) {
    Section section{"frames", "Whole frames", {}, {}};
    section.prose = {
        "A picture is more than its intersections: camera rays have to be made, surfaces and "
        "lights "
        "evaluated, samples added up. The overhead is the time of the rendering over the time that "
        "the intersector alone takes for the same rays; 1 would be a renderer that does nothing "
        "else."};
    const std::vector<frames::FrameFigures>& all = results.frames.list;
    if (all.empty()) return section;
    section.figures = {{"Parts of a frame",
                        "Seconds of processor time on one thread. Shading is what is left of the "
                        "rendering: surfaces, lights, and the rays that they send.",
                        frames_command(results.settings), results.frames.date, parts(all)}};
    return section;
}

}  // namespace etalon::bench_report
