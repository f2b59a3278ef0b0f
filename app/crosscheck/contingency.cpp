#include "app/crosscheck/contingency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/crosscheck/classification.h"

namespace etalon::crosscheck {
namespace {

constexpr std::size_t few = 3;

std::string rays(std::size_t count) {
    return fmt::format("{} ray{}", count, count == 1 ? "" : "s");
}

/// Returns how probable it is that one of two that are equally likely happens at most `less` times
/// of all, or at least `more` times: McNemar's test by the binomial distribution, which is right
/// for few, too.
double probability(std::size_t less, std::size_t more) {
    const auto all = static_cast<double>(less + more);
    auto k = static_cast<double>(less);
    double term = std::exp(std::lgamma(all + 1) - std::lgamma(k + 1) - std::lgamma(all - k + 1) -
                           all * std::numbers::ln2);
    double sum = 0;
    for (; k >= 0 && term > 1e-9 * sum; --k) {
        sum += term;
        term *= k / (all - k + 1);
    }
    return std::min(2 * sum, 1.0);
}

}  // namespace

double Contingency::mcnemar() const {
    const auto n10 = static_cast<double>(only_a_right), n01 = static_cast<double>(only_b_right);
    return n01 + n10 == 0 ? 0 : (n01 - n10) * (n01 - n10) / (n01 + n10);
}

std::string Contingency::in_words() const {
    if (only_a_right + only_b_right == 0) {
        if (both_wrong == 0) {
            return fmt::format("{} and {} are never wrong in {} that the oracle decides.", a, b,
                               rays(both_right));
        }
        return fmt::format("{} and {} are wrong in the same {}.", a, b, rays(both_wrong));
    }
    const bool b_is_worse = only_a_right >= only_b_right;
    const std::size_t more = std::max(only_a_right, only_b_right);
    const std::size_t less = std::min(only_a_right, only_b_right);
    std::string text = fmt::format("{} is wrong where {} is right in {}; ", b_is_worse ? b : a,
                                   b_is_worse ? a : b, rays(more));
    if (less == 0) return text + "never the other way round.";
    return text + fmt::format("the other way round in {} (chance alone {} do that).", less,
                              probability(less, more) < 0.05 ? "would rarely" : "may");
}

Contingency contingency(const std::vector<Trial>& trials, const CrosscheckedTracer& a,
                        const CrosscheckedTracer& b) {
    Contingency table{a.name, b.name};
    for (std::size_t t = 0; t < trials.size(); ++t) {
        for (std::size_t i = 0; i < trials[t].rays.size(); ++i) {
            const Classification by_a = classify(trials[t], i, a.answers[t].all[i], a.exact);
            const Classification by_b = classify(trials[t], i, b.answers[t].all[i], b.exact);
            if (!by_a.decided) continue;
            if (by_a.right()) {
                ++(by_b.right() ? table.both_right : table.only_a_right);
            } else {
                ++(by_b.right() ? table.only_b_right : table.both_wrong);
            }
        }
    }
    return table;
}

std::vector<Contingency> contingencies(const std::vector<Trial>& trials,
                                       const std::vector<CrosscheckedTracer>& tracers) {
    std::vector<Contingency> tables;
    const std::size_t firsts = tracers.size() <= few ? tracers.size() : 1;
    for (std::size_t a = 0; a < firsts; ++a) {
        for (std::size_t b = a + 1; b < tracers.size(); ++b) {
            tables.push_back(contingency(trials, tracers[a], tracers[b]));
        }
    }
    return tables;
}

}  // namespace etalon::crosscheck
