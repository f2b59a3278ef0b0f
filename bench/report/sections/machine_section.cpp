// Section on the machine and the versions.
#include <fmt/format.h>

#include "app/common/backends.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

Table facts(const Results& results) {
    const Machine& m = results.machine;
    Table table{{{"", false}, {"", false}}, {}};
    table.rows = {{{"processor"}, {m.processor}},
                  {{"cores that may be used"}, {std::to_string(m.cores)}},
                  {{"memory"}, {bytes(m.memory_bytes)}},
                  {{"system"}, {m.system}},
                  {{"load when it began"}, {fmt::format("{:.2f}", m.load)}},
                  {{"Etalon"}, {fmt::format("{}, commit {}", m.version, m.commit)}},
                  {{"compiler"}, {m.compiler}},
                  {{"flags"}, {m.flags}},
                  {{"Embree"}, {fmt::format("{}, {}", m.embree, m.embree_isa)}}};
    return table;
}

/// Returns the instruction set of a backend, which is known only if the backend was built.
std::string isa_of(const Results& results, std::string_view backend) {
    for (const speed::SceneFigures& scene : results.scenes.list) {
        for (const speed::BuildFigures& b : scene.builds) {
            if (b.tracer == backend) return b.isa;
        }
    }
    return "–";
}

Table backends(const Results& results) {
    Table table{{{"backend", false}, {"how", false}, {"exact", false}, {"SIMD", false}}, {}};
    for (const Backend& b : all_backends()) {
        table.rows.push_back({{std::string(b.name)},
                              {std::string(b.summary)},
                              {b.exact ? "yes" : "no"},
                              {isa_of(results, b.name)}});
    }
    return table;
}

}  // namespace

Section machine_section(const Results& results) {
    Section section{"machine", "The machine and the versions", {}, {}};
    const std::string command = command_of(results.settings);
    section.figures.push_back({"Machine", "Where and with what all this was measured.", command,
                               results.begun, facts(results)});
    section.figures.push_back(
        {"Backends",
         "The backends, and the instruction sets of those whose speed was measured. "
         "Exact backends give identical bits.",
         command, results.begun, backends(results)});
    return section;
}

}  // namespace etalon::bench_report
