#include "app/crosscheck/crosscheck_counts.h"

#include <algorithm>
#include <cmath>

namespace etalon::crosscheck {
namespace {

void count(const Classification& classification, bool found, CrosscheckCounts& counts) {
    counts.undecidable += classification.decided ? 0 : 1;
    counts.class_errors += classification.wrong_class ? 1 : 0;
    counts.primitive_errors += classification.wrong_primitive ? 1 : 0;
    counts.t_errors += classification.wrong_t ? 1 : 0;
    counts.occlusion_errors += classification.wrong_occlusion ? 1 : 0;
    counts.differences += classification.differs ? 1 : 0;
    const bool on_target =
        classification.decided && !classification.wrong_class && !classification.wrong_primitive;
    if (found && on_target) counts.t_ulp.push_back(classification.t_ulp);
}

}  // namespace

double CrosscheckCounts::t_quantile(double q) const {
    if (t_ulp.empty()) return 0;
    const double rank = std::ceil(q * static_cast<double>(t_ulp.size()));
    return t_ulp[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

CrosscheckCounts counts_of(const Trial& trial, const Answers& answers, bool exact) {
    CrosscheckCounts result;
    result.rays = trial.rays.size();
    result.seconds = answers.seconds;
    for (std::size_t i = 0; i < trial.rays.size(); ++i) {
        const Answer& answer = answers.all[i];
        count(classify(trial, i, answer, exact), answer.closest.has_value(), result);
    }
    std::sort(result.t_ulp.begin(), result.t_ulp.end());
    return result;
}

CrosscheckCounts sum(const std::vector<CrosscheckCounts>& all_counts) {
    CrosscheckCounts all;
    for (const CrosscheckCounts& t : all_counts) {
        all.rays += t.rays;
        all.undecidable += t.undecidable;
        all.class_errors += t.class_errors;
        all.primitive_errors += t.primitive_errors;
        all.t_errors += t.t_errors;
        all.occlusion_errors += t.occlusion_errors;
        all.differences += t.differences;
        all.t_ulp.insert(all.t_ulp.end(), t.t_ulp.begin(), t.t_ulp.end());
        all.seconds += t.seconds;
    }
    std::sort(all.t_ulp.begin(), all.t_ulp.end());
    return all;
}

}  // namespace etalon::crosscheck
