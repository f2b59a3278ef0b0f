#include <algorithm>

#include "bench/speed/report/cells.h"
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

/// Returns a cell with a number of errors.
template <std::string (*Cell)(const Errors& errors)>
std::string any_query(const RayLine& line) {
    return line.has_errors() ? Cell(line.figures.errors) : "";
}

/// The same for errors that occlusion queries cannot have.
template <std::string (*Cell)(const Errors& errors)>
std::string nearest_hit(const RayLine& line) {
    return line.has_errors() && line.kind.occlusion ? "-" : any_query<Cell>(line);
}

std::string reference(const Errors& e) {
    return e.reference;
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

std::string disputed_unsure(const Errors& e) {
    return count(e.disputed.undecidable);
}

std::string disputed_errors(const Errors& e) {
    return count(e.disputed.errors());
}

std::string ulps(const Errors& e) {
    return accuracy::brief(std::max(e.sample.t_ulps, e.disputed.t_ulps));
}

std::string sampled_errors(const Errors& e) {
    return count(e.sample.errors());
}

/// Narrow tables have the speed and the number of wrong answers; wide ones also their kinds, and
/// the differences from the reference.
const table::Columns<RayLine>& ray_columns() {
    static const table::Columns<RayLine> all = {
        {"", "threads", 7, threads<RayLine>},
        {"Mrays/s", "CPU", 8, cpu_rate, "million rays a second of CPU time"},
        {"Mrays/s", "wall", 8, wall_rate, "million rays a second"},
        {"to", "builtin", 8, ratio<RayLine, &Runs::ratio>, meaning::builtin},
        {"", "+-", 6, spread<RayLine>, meaning::spread},
        {"to", "robust", 8, ratio<RayLine, &Runs::ratio_robust>, meaning::robust, Detail::wide},
        {"of one:", "CPU", 8, scaling<RayLine, &Runs::cpu_scaling>, meaning::cpu_scaling,
         Detail::wide},
        {"of one:", "wall", 8, scaling<RayLine, &Runs::wall_scaling>, meaning::wall_scaling,
         Detail::wide},
        {"differs", "from", 13, any_query<reference>, "the exact backend it is compared with",
         Detail::wide},
        {"of", "rays", 8, any_query<disagreement<&Disagreement::rays>>, "rays compared with it",
         Detail::wide},
        {"hit or", "miss", 7, any_query<disagreement<&Disagreement::hit_or_miss>>,
         "of these, one hits something and the other nothing", Detail::wide},
        {"other", "prim", 7, nearest_hit<disagreement<&Disagreement::primitive>>,
         "both hit, but different primitives", Detail::wide},
        {"bits", "of t", 8, nearest_hit<disagreement<&Disagreement::distance>>,
         "the same primitive at another distance, if only by the last bit", Detail::wide},
        {"sampled", "rays", 8, any_query<sample<&OracleCheck::rays>>, meaning::sampled},
        {"sampled", "unsure", 8, any_query<sample<&OracleCheck::undecidable>>,
         "of these, rays that the oracle cannot decide", Detail::wide},
        {"sampled", "wrong", 8, any_query<sampled_errors>, meaning::wrong_of_sampled},
        {"false", "hits", 7, any_query<sample<&OracleCheck::false_hits>>,
         "of the sampled rays: a hit where there is nothing", Detail::wide},
        {"false", "misses", 7, any_query<sample<&OracleCheck::false_misses>>,
         "of the sampled rays: a miss where there is something", Detail::wide},
        {"wrong", "prim", 7, nearest_hit<sample<&OracleCheck::wrong_primitives>>,
         "of the sampled rays: another primitive than the nearest", Detail::wide},
        {"wrong", "root", 7, nearest_hit<sample<&OracleCheck::wrong_roots>>,
         "of the sampled rays: the nearest primitive, but not where the ray meets it first",
         Detail::wide},
        {"t, in", "ulp max", 8, nearest_hit<ulps>,
         "largest error of the distance t among checked rays, in units in the last place of a "
         "float",
         Detail::wide},
        {"disputed", "rays", 9, any_query<disputed_rays>, meaning::disputed},
        {"disputed", "unsure", 9, any_query<disputed_unsure>,
         "of these, rays that the oracle cannot decide", Detail::wide},
        {"disputed", "wrong", 9, any_query<disputed_errors>, meaning::wrong_of_disputed},
    };
    return all;
}

}  // namespace

std::string heading_of_rays(Detail detail) {
    return table::heading(beginning("rays", ""), ray_columns(), detail);
}

std::string table_of(const KindFigures& kind, Detail detail) {
    std::string text;
    for (const RayFigures& r : kind.tracers) {
        for (const Runs& runs : r.by_threads) {
            text += table::line_of(beginning(kind.kind, r.tracer), {kind, r, runs}, ray_columns(),
                                   detail);
        }
    }
    return text;
}

void explain_rays(Detail detail, table::Legend& legend) {
    table::explain(ray_columns(), detail, legend);
    legend.add(".", "none");
    legend.add("-", meaning::nothing);
}

}  // namespace etalon::speed
