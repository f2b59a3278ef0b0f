#include "app/crosscheck/crosscheck_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace etalon::crosscheck {
namespace {

/// Returns `describe` of each backend below a line with its name. Backends with the same text, as
/// exact ones, share it.
template <class F>
std::string by_backend(const Results& results, const std::string& before_name, const F& describe) {
    std::vector<std::string> names, texts;
    for (const BackendResults& b : results.backends) {
        const std::string text = describe(b);
        const auto same = std::find(texts.begin(), texts.end(), text);
        if (same != texts.end()) {
            names[static_cast<std::size_t>(same - texts.begin())] += ", " + b.name;
        } else {
            names.push_back(b.name);
            texts.push_back(text);
        }
    }
    std::string all;
    for (std::size_t i = 0; i < texts.size(); ++i) all += before_name + names[i] + texts[i];
    return all;
}

std::string row(const std::string& kind, const CrosscheckCounts& t) {
    return fmt::format(
        "  {:<6} {:>9} {:>11} {:>7} {:>9} {:>6} {:>9} {:>6} {:>10.3g} {:>9.3g} {:>9.3g}\n", kind,
        t.rays, t.undecidable, t.class_errors, t.primitive_errors, t.t_errors, t.occlusion_errors,
        t.differences, t.t_quantile(0.5), t.t_quantile(0.99), t.t_quantile(1));
}

std::string counts_as_text(const Results& results) {
    std::string text = fmt::format("{:>71} {:>30}\n", "wrong answers", "error of t in ulp");
    text += fmt::format("{:<8} {:>9} {:>11} {:>7} {:>9} {:>6} {:>9} {:>6} {:>10} {:>9} {:>9}\n",
                        "rays", "asked", "undecidable", "class", "primitive", "t", "occlusion",
                        "unlike", "median", "99 %", "max");
    return text + by_backend(results, "", [&](const BackendResults& b) {
               std::string rows = "\n";
               for (std::size_t k = 0; k < results.kinds.size(); ++k) {
                   rows += row(results.kinds[k], b.by_kind[k]);
               }
               return rows + row("all", b.total);
           });
}

std::string contingencies_as_text(const Results& results) {
    if (results.contingencies.empty()) return "";
    std::string text =
        fmt::format("\n{:<32} {:>10} {:>9} {:>9} {:>10} {:>15}\n", "A, B: who is right", "both",
                    "only A", "only B", "neither", "McNemar's chi2");
    for (const Contingency& c : results.contingencies) {
        text +=
            fmt::format("{:<32} {:>10} {:>9} {:>9} {:>10} {:>15.4g}\n", c.a + ", " + c.b,
                        c.both_right, c.only_a_right, c.only_b_right, c.both_wrong, c.mcnemar());
    }
    for (const Contingency& c : results.contingencies) text += c.in_words() + "\n";
    return text;
}

}  // namespace

std::string as_text(const Results& results) {
    const char* partial =
        results.stopped ? "\nStopped by a signal: these are not all rays and backends asked for.\n"
                        : "";
    return counts_as_text(results) + contingencies_as_text(results) + partial;
}

std::string as_rays(const Results& results) {
    return by_backend(results, "# ", [](const BackendResults& b) {
        if (b.worst.empty()) return std::string(": no rays\n");
        std::string text =
            b.total.clean() ? ": never wrong; the largest errors of t\n" : ": the worst rays\n";
        for (const WorstRay& worst : b.worst) text += trace_lines(worst);
        return text;
    });
}

}  // namespace etalon::crosscheck
