#include "bench/speed/report/table.h"

#include <fmt/format.h>

#include "bench/accuracy/report/numbers.h"

namespace etalon::speed {
namespace {

using accuracy::brief;
using accuracy::brief_count;

/// What a line is about.
struct BuildLine {
    const BuildFigures& figures;
    const Runs& runs;
};

struct RayLine {
    const RayFigures& figures;
    const Runs& runs;
    const KindFigures& kind;

    double rays() const { return static_cast<double>(kind.rays); }

    /// Errors do not depend on the number of threads: they stand in the first line.
    bool has_errors() const { return &runs == &figures.by_threads.front(); }
};

template <class Line>
struct Column {
    const char *above, *name;
    int width;
    std::string (*cell)(const Line& line);
};

std::string fixed(double value) {
    return fmt::format("{:.3f}", value);
}

std::string count(std::uint64_t n) {
    return n == 0 ? "." : brief_count(n);
}

template <class Line>
std::string threads(const Line& line) {
    return fmt::format("{}", line.runs.threads);
}

template <class Line, Estimate Runs::*Which>
std::string ratio(const Line& line) {
    return fixed((line.runs.*Which).median);
}

template <class Line>
std::string spread(const Line& line) {
    return fixed(line.runs.ratio.spread);
}

template <class Line, Estimate Runs::*Which>
std::string scaling(const Line& line) {
    return line.runs.threads == 1 ? "-" : fixed((line.runs.*Which).median);
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

template <std::size_t Disagreement::*Count>
std::string disagreement(const Errors& e) {
    return count(e.disagreement.*Count);
}

template <std::uint64_t Judgement::*Count>
std::string judgement(const Errors& e) {
    return count(e.judgement.*Count);
}

std::string ulps(const Errors& e) {
    return brief(e.judgement.t_ulps);
}

std::string cpu_rate(const RayLine& line) {
    return fixed(line.rays() / median(line.runs.cpu()) * 1e-6);
}

std::string wall_rate(const RayLine& line) {
    return fixed(line.rays() / median(line.runs.wall()) * 1e-6);
}

constexpr Column<BuildLine> build_columns[] = {
    {"", "threads", 8, threads<BuildLine>},
    {"CPU", "seconds", 9, [](const BuildLine& l) { return brief(median(l.runs.cpu())); }},
    {"wall", "seconds", 9, [](const BuildLine& l) { return brief(median(l.runs.wall())); }},
    {"to", "builtin", 9, ratio<BuildLine, &Runs::ratio>},
    {"", "+-", 7, spread<BuildLine>},
    {"to", "robust", 8, ratio<BuildLine, &Runs::ratio_robust>},
    {"of one:", "CPU", 9, scaling<BuildLine, &Runs::cpu_scaling>},
    {"", "wall", 7, scaling<BuildLine, &Runs::wall_scaling>},
    {"bytes a", "primitive", 11,
     [](const BuildLine& l) { return fmt::format("{:.1f}", l.figures.bytes_per_primitive); }},
};

constexpr Column<RayLine> ray_columns[] = {
    {"", "threads", 8, threads<RayLine>},
    {"Mrays/s", "CPU", 9, cpu_rate},
    {"", "wall", 9, wall_rate},
    {"to", "builtin", 9, ratio<RayLine, &Runs::ratio>},
    {"", "+-", 7, spread<RayLine>},
    {"to", "robust", 8, ratio<RayLine, &Runs::ratio_robust>},
    {"of one:", "CPU", 9, scaling<RayLine, &Runs::cpu_scaling>},
    {"", "wall", 7, scaling<RayLine, &Runs::wall_scaling>},
    {"differs", "from", 9, any_query<reference>},
    {"of", "rays", 8, any_query<disagreement<&Disagreement::rays>>},
    {"hit or", "miss", 7, any_query<disagreement<&Disagreement::hit_or_miss>>},
    {"", "prim", 7, nearest_hit<disagreement<&Disagreement::primitive>>},
    {"bits", "of t", 8, nearest_hit<disagreement<&Disagreement::distance>>},
    {"oracle:", "rays", 9, any_query<judgement<&Judgement::rays>>},
    {"false", "hits", 7, any_query<judgement<&Judgement::false_hits>>},
    {"false", "misses", 7, any_query<judgement<&Judgement::false_misses>>},
    {"wrong", "prim", 7, nearest_hit<judgement<&Judgement::wrong_primitives>>},
    {"t, in", "ulp max", 8, nearest_hit<ulps>},
};

std::string stub(const std::string& what, const std::string& contender) {
    return fmt::format("{:<8}{:<22}", what, contender);
}

template <class Columns>
std::string heading_of(const std::string& what, const Columns& columns) {
    std::string above = stub("", ""), below = stub(what, "");
    for (const auto& c : columns) {
        above += fmt::format("{:>{}}", c.above, c.width);
        below += fmt::format("{:>{}}", c.name, c.width);
    }
    return above + "\n" + below + "\n";
}

template <class Line, class Columns>
std::string text_of(std::string text, const Line& line, const Columns& columns) {
    for (const auto& c : columns) text += fmt::format("{:>{}}", c.cell(line), c.width);
    text.resize(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

/// One contender over all kinds of rays.
struct Sum {
    Sum(const SceneFigures& scene, std::size_t contender) {
        for (const KindFigures& kind : scene.kinds) {
            const RayFigures& r = kind.contenders[contender];
            ratios.push_back(r.by_threads.front().ratio.median);
            robust_ratios.push_back(r.by_threads.front().ratio_robust.median);
            judged += r.errors.judgement.rays;
            wrong += r.errors.judgement.errors();
        }
    }

    std::vector<double> ratios, robust_ratios;
    std::uint64_t judged = 0, wrong = 0;
};

}  // namespace

std::string table(const std::vector<BuildFigures>& builds) {
    std::string text = heading_of("build", build_columns);
    for (const BuildFigures& b : builds) {
        for (const Runs& runs : b.by_threads) {
            text += text_of(stub("build", b.contender), BuildLine{b, runs}, build_columns);
        }
    }
    return text;
}

std::string heading_of_rays() {
    return heading_of("rays", ray_columns);
}

std::string table(const KindFigures& kind) {
    std::string text;
    for (const RayFigures& r : kind.contenders) {
        for (const Runs& runs : r.by_threads) {
            const RayLine line{r, runs, kind};
            text += text_of(stub(kind.kind, r.contender), line, ray_columns);
        }
    }
    return text;
}

std::string summary(const SceneFigures& scene) {
    std::string text = scene.scene + ", to builtin (to robust; wrong of judged):";
    for (std::size_t i = 0; i < scene.builds.size() && !scene.kinds.empty(); ++i) {
        const Sum sum(scene, i);
        text += fmt::format(" {} {:.3f} ({:.3f}; {} of {}),", scene.builds[i].contender,
                            geometric_mean(sum.ratios), geometric_mean(sum.robust_ratios),
                            sum.wrong, sum.judged);
    }
    text.back() = '\n';
    return text;
}

}  // namespace etalon::speed
