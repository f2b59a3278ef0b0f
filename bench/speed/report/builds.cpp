#include "bench/speed/report/columns.h"
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

constexpr Column<BuildLine> columns[] = {
    {"", "threads", 8, threads<BuildLine>},
    {"CPU", "seconds", 9, cpu_seconds},
    {"wall", "seconds", 9, wall_seconds},
    {"to", "builtin", 9, ratio<BuildLine, &Runs::ratio>},
    {"", "+-", 7, spread<BuildLine>},
    {"to", "robust", 8, ratio<BuildLine, &Runs::ratio_robust>},
    {"of one:", "CPU", 9, scaling<BuildLine, &Runs::cpu_scaling>},
    {"", "wall", 7, scaling<BuildLine, &Runs::wall_scaling>},
    {"bytes a", "primitive", 11, bytes},
};

}  // namespace

std::string table(const std::vector<BuildFigures>& builds) {
    const std::span<const Column<BuildLine>> all(columns);
    std::string text = heading("build", all);
    for (const BuildFigures& b : builds) {
        for (const Runs& runs : b.by_threads) {
            text += text_of(beginning("build", b.tracer), BuildLine{b, runs}, all);
        }
    }
    return text;
}

}  // namespace etalon::speed
