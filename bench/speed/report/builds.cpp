#include "bench/speed/report/cells.h"
#include "bench/speed/report/speed_table.h"

namespace etalon::speed {
namespace {

struct BuildLine {
    const BuildFigures& figures;
    const Runs& runs;
};

std::string cpu_seconds(const BuildLine& line) {
    return accuracy::brief(median(line.runs.cpu()));
}

std::string wall_seconds(const BuildLine& line) {
    return accuracy::brief(median(line.runs.wall()));
}

std::string bytes(const BuildLine& line) {
    return fmt::format("{:.1f}", line.figures.bytes_per_primitive);
}

const table::Columns<BuildLine>& build_columns() {
    static const table::Columns<BuildLine> all = {
        {"", "threads", 7, threads<BuildLine>},
        {"CPU", "seconds", 9, cpu_seconds},
        {"wall", "seconds", 9, wall_seconds},
        {"to", "builtin", 9, ratio<BuildLine, &Runs::ratio>, meaning::builtin},
        {"", "+-", 6, spread<BuildLine>, meaning::spread},
        {"to", "robust", 8, ratio<BuildLine, &Runs::ratio_robust>, meaning::robust, Detail::wide},
        {"of one:", "CPU", 9, scaling<BuildLine, &Runs::cpu_scaling>, meaning::cpu_scaling,
         Detail::wide},
        {"of one:", "wall", 9, scaling<BuildLine, &Runs::wall_scaling>, meaning::wall_scaling},
        {"bytes a", "primitive", 11, bytes, "memory that the structure keeps"},
    };
    return all;
}

}  // namespace

std::string table_of(const std::vector<BuildFigures>& builds, Detail detail) {
    std::string text = table::heading(beginning("build", ""), build_columns(), detail);
    for (const BuildFigures& b : builds) {
        for (const Runs& runs : b.by_threads) {
            text +=
                table::line_of(beginning("build", b.tracer), {b, runs}, build_columns(), detail);
        }
    }
    return text;
}

void explain_builds(Detail detail, table::Legend& legend) {
    table::explain(build_columns(), detail, legend);
    legend.add("-", meaning::nothing);
}

}  // namespace etalon::speed
