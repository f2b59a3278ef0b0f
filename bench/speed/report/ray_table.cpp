#include <algorithm>

#include "bench/speed/report/columns.h"
#include "bench/speed/report/speed_table.h"

namespace etalon::speed {
namespace {

struct RayLine {
    const KindFigures& kind;
    const RayFigures& figures;
    const Runs& runs;

    bool has_errors() const { return &runs == &figures.by_threads.front(); }
};

std::string rate(const RayLine& line, const std::vector<double>& seconds) {
    return figure(static_cast<double>(line.kind.rays) / median(seconds) * 1e-6);
}

std::string cpu_rate(const RayLine& line) {
    return rate(line, line.runs.cpu());
}

std::string wall_rate(const RayLine& line) {
    return rate(line, line.runs.wall());
}

/// A cell about errors.
template <std::string (*Cell)(const Errors& errors)>
std::string any_query(const RayLine& line) {
    return line.has_errors() ? Cell(line.figures.errors) : "";
}

/// The same for what an occlusion query does not tell.
template <std::string (*Cell)(const Errors& errors)>
std::string nearest_hit(const RayLine& line) {
    return line.has_errors() && line.kind.occlusion ? "-" : any_query<Cell>(line);
}

std::string reference(const Errors& e) {
    return e.reference;
}

std::string count(std::uint64_t n) {
    return n == 0 ? "." : accuracy::brief_count(n);
}

template <std::size_t Disagreement::*Count>
std::string disagreement(const Errors& e) {
    return count(e.disagreement.*Count);
}

template <std::uint64_t OracleCheck::*Count>
std::string sample(const Errors& e) {
    return count(e.sample.*Count);
}

std::string disputed_rays(const Errors& e) {
    return count(e.disputed.rays);
}

std::string disputed_errors(const Errors& e) {
    return count(e.disputed.errors());
}

std::string ulps(const Errors& e) {
    return accuracy::brief(std::max(e.sample.t_ulps, e.disputed.t_ulps));
}

constexpr Column<RayLine> columns[] = {
    {"", "threads", 8, threads<RayLine>},
    {"Mrays/s", "CPU", 9, cpu_rate},
    {"", "wall", 9, wall_rate},
    {"to", "builtin", 9, ratio<RayLine, &Runs::ratio>},
    {"", "+-", 7, spread<RayLine>},
    {"to", "robust", 8, ratio<RayLine, &Runs::ratio_robust>},
    {"of one:", "CPU", 9, scaling<RayLine, &Runs::cpu_scaling>},
    {"", "wall", 7, scaling<RayLine, &Runs::wall_scaling>},
    {"differs", "from", 13, any_query<reference>},
    {"of", "rays", 8, any_query<disagreement<&Disagreement::rays>>},
    {"hit or", "miss", 7, any_query<disagreement<&Disagreement::hit_or_miss>>},
    {"", "prim", 7, nearest_hit<disagreement<&Disagreement::primitive>>},
    {"bits", "of t", 8, nearest_hit<disagreement<&Disagreement::distance>>},
    {"oracle:", "rays", 9, any_query<sample<&OracleCheck::rays>>},
    {"false", "hits", 7, any_query<sample<&OracleCheck::false_hits>>},
    {"false", "misses", 7, any_query<sample<&OracleCheck::false_misses>>},
    {"wrong", "prim", 7, nearest_hit<sample<&OracleCheck::wrong_primitives>>},
    {"t, in", "ulp max", 8, nearest_hit<ulps>},
    {"in", "dispute", 9, any_query<disputed_rays>},
    {"", "wrong", 7, any_query<disputed_errors>},
};

}  // namespace

std::string heading_of_rays() {
    return heading("rays", std::span<const Column<RayLine>>(columns));
}

std::string table(const KindFigures& kind) {
    const std::span<const Column<RayLine>> all(columns);
    std::string text;
    for (const RayFigures& r : kind.tracers) {
        for (const Runs& runs : r.by_threads) {
            text += text_of(beginning(kind.kind, r.tracer), RayLine{kind, r, runs}, all);
        }
    }
    return text;
}

}  // namespace etalon::speed
