// Section on speed: rays per second, with the number of wrong answers beside it.
#include <fmt/format.h>

#include <algorithm>

#include "app/common/backends.h"
#include "bench/accuracy/report/plot.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"
#include "bench/speed/timed_tracer.h"
#include "bench/speed/totals.h"

namespace etalon::bench_report {
namespace {

using namespace speed;

double rate(const KindFigures& kind, const std::vector<double>& seconds) {
    return 1e-6 * static_cast<double>(kind.rays) / median(seconds);
}

/// Returns the number of wrong answers to a sample of the rays and, below, to those on which
/// tracers disagree. Their sum would be no rate of anything.
Cell wrong_of(const CheckedAnswers& sampled, const CheckedAnswers& disputed) {
    Cell cell = bench_report::wrong_of(sampled.wrong, sampled.rays);
    if (disputed.rays == 0) return cell;
    const Cell more = bench_report::wrong_of(disputed.wrong, disputed.rays);
    cell.text += "\n" + more.text + " disputed";
    if (more.mark == Mark::bad) cell.mark = more.mark;
    return cell;
}

Bar bar_of(const KindFigures& kind, const RayFigures& r) {
    const Runs& runs = r.by_threads.front();
    CheckedAnswers sampled, disputed;
    sampled.add(r.errors.sample);
    disputed.add(r.errors.disputed);
    std::vector<double> rates;
    for (const double seconds : runs.cpu()) rates.push_back(rate(kind, {seconds}));
    const Estimate speed = estimate(rates);
    return {r.tracer,
            colour_of(r.tracer),
            speed.median,
            speed.spread.value_or(0),
            three_digits(speed.median),
            times(runs.ratio),
            wrong_of(sampled, disputed)};
}

Figure figure_of(const Results& results, const SceneFigures& scene) {
    Bars bars;
    for (const KindFigures& kind : scene.kinds) {
        BarGroup group{kind.kind + " rays", "Mrays/s", "× builtin", "wrong", {}};
        for (const RayFigures& r : kind.tracers) group.bars.push_back(bar_of(kind, r));
        bars.groups.push_back(std::move(group));
    }
    return {
        fmt::format("{}, {}", scene.scene, count_of(scene.primitives, "primitive")),
        "Million rays per CPU second on one thread; that as a multiple of embree-builtin; wrong "
        "answers of those checked.",
        speed_command(results.settings, scene.scene), results.scenes.date, std::move(bars)};
}

double per_million(const CheckedAnswers& j) {
    return j.rays == 0 ? 0 : 1e6 * static_cast<double>(j.wrong) / static_cast<double>(j.rays);
}

bool is_exact(std::string_view tracer) {
    return std::ranges::any_of(all_backends(),
                               [&](const Backend& b) { return b.name == tracer && b.exact; });
}

Figure overview(const Results& results) {
    BarGroup group{"backend", "× builtin", "", "wrong", {}};
    for (const Totals& totals : totals_of(results.scenes.list)) {
        const double mean = geometric_mean(totals.ratios);
        group.bars.push_back({totals.tracer, colour_of(totals.tracer), mean, 0, three_digits(mean),
                              "", wrong_of(totals.sampled, totals.disputed)});
    }
    return {"All together",
            fmt::format("Times as fast as embree-builtin: geometric means over {} and all kinds of "
                        "rays.",
                        count_of(results.scenes.list.size(), "scene")),
            speed_command(results.settings), results.scenes.date, Bars{{std::move(group)}}};
}

/// Plots the geometric mean over scenes of the cost of a ray against the share of wrong answers.
accuracy::Scatter scatter_of(const std::vector<Totals>& all) {
    accuracy::Scatter scatter{baseline, 0, {}};
    for (const Totals& totals : all) {
        accuracy::Point point;
        point.tracer = totals.tracer;
        point.exact = is_exact(totals.tracer);
        point.cost = 1 / geometric_mean(totals.ratios);
        point.error = per_million(totals.sampled);
        point.worst_case = "all scenes";
        scatter.points.push_back(point);
    }
    std::ranges::sort(scatter.points, {}, &accuracy::Point::cost);
    accuracy::mark_efficient(scatter.points);
    return scatter;
}

Figure errors_against_cost(const Results& results) {
    const std::string svg = accuracy::small_plot(
        scatter_of(totals_of(results.scenes.list)),
        {"Errors against cost", "cost of a ray, relative to embree-builtin", "wrong in 10⁶ rays"});
    Charts charts{{{"All scenes and kinds of rays", svg}},
                  {{1, "promises to be right"}, {2, "float backend"}}};
    return {"What a ray costs, and how often its answer is wrong",
            "To the right what a ray costs relative to embree-builtin, the geometric mean over all "
            "scenes and kinds of rays; upwards wrong answers to a sample spread evenly over all. "
            "Best is "
            "the lower left; filled marks are those that nothing beats in both.",
            speed_command(results.settings), results.scenes.date, std::move(charts)};
}

const std::vector<Column> columns = {
    {"scene", false}, {"rays", false},       {"backend", false}, {"threads"},
    {"Mrays/CPU s"},  {"Mrays/s"},           {"× builtin"},      {"±"},
    {"× robust"},     {"× one thread"},      {"other hits"},     {"wrong of sample"},
    {"sample"},       {"wrong of disputed"}, {"disputed"},
};

/// Returns the number of rays with another answer than the reference's. The bits of t count for
/// exact tracers only.
std::size_t other_hits(const RayFigures& r) {
    const Disagreement& d = r.errors.disagreement;
    return d.hit_or_miss + d.primitive + (find_tracer(r.tracer).exact ? d.distance : 0);
}

std::vector<Cell> row_of(const SceneFigures& scene, const KindFigures& kind, const RayFigures& r,
                         const Runs& runs) {
    const auto count = [](std::uint64_t n) { return Cell{grouped(n)}; };
    const auto errors = [](std::uint64_t n) {
        return Cell{grouped(n), n > 0 ? Mark::bad : Mark::none};
    };
    const Errors& e = r.errors;
    return {{scene.scene},
            {kind.kind},
            {r.tracer},
            {std::to_string(runs.threads)},
            {three_digits(rate(kind, runs.cpu()))},
            {three_digits(rate(kind, runs.wall()))},
            {three_digits(runs.ratio.median)},
            {runs.ratio.spread ? fmt::format("{:.3f}", *runs.ratio.spread) : "–"},
            {three_digits(runs.ratio_robust.median)},
            {three_digits(runs.wall_scaling.median)},
            errors(other_hits(r)),
            errors(e.sample.errors()),
            count(e.sample.rays),
            errors(e.disputed.errors()),
            count(e.disputed.rays)};
}

Figure all_numbers(const Results& results) {
    Table table{columns, {}};
    for (const SceneFigures& scene : results.scenes.list) {
        for (const KindFigures& kind : scene.kinds) {
            for (const RayFigures& r : kind.tracers) {
                for (const Runs& runs : r.by_threads) {
                    table.rows.push_back(row_of(scene, kind, r, runs));
                }
            }
        }
    }
    return {"All numbers of this section",
            "“Other hits” counts rays on which this backend does not hit what an exact one hits "
            "or, if it is exact itself, not at the same distance to the last bit; rays are "
            "disputed where not all backends hit the same.",
            speed_command(results.settings),
            results.scenes.date,
            std::move(table),
            true};
}

}  // namespace

Section speed_section(const Results& results) {
    const Settings& settings = results.settings;
    Section section{"speed", "Speed, and the errors beside it", {}, {}};
    section.prose = {
        fmt::format(
            "Every backend traces the same rays, in turn, {} times; figures are medians, and ± is "
            "the interquartile range. CPU time of pinned threads, which depends little on what "
            "else the machine does.",
            settings.speed_config.repeats),
        "Errors are given beside each speed. A quad-precision oracle checks a sample of the rays "
        "and, of those on which the backends do not agree, as many as time allows: “wrong” are "
        "hits where there is nothing, misses where there is something, and other primitives than "
        "the nearest. The second number is that of the disputed rays."};
    if (results.scenes.list.empty()) return section;
    section.figures.push_back(errors_against_cost(results));
    section.figures.push_back(overview(results));
    for (const SceneFigures& scene : results.scenes.list) {
        section.figures.push_back(figure_of(results, scene));
    }
    section.figures.push_back(all_numbers(results));
    return section;
}

}  // namespace etalon::bench_report
