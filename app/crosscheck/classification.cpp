#include "app/crosscheck/classification.h"

#include <algorithm>

#include "core/numerics/ulp.h"

namespace etalon::crosscheck {
namespace {

double error_of(double t, const OracleAnswer& truth) {
    return static_cast<double>(magnitude(Quad(t) - truth.exact_t));
}

bool is_nearest(const Hit& hit, const OracleAnswer& truth) {
    return std::binary_search(truth.tied.begin(), truth.tied.end(),
                              key_of(hit.primitive, hit.instance));
}

double largest_error(const Trial& trial, std::size_t ray, bool exact) {
    const OracleAnswer& truth = trial.truth[ray];
    return exact ? truth.exact_limit() : truth.root_limit(trial.rays[ray], trial.size);
}

}  // namespace

Classification classify(const Trial& trial, std::size_t ray, const Answer& answer, bool exact) {
    const OracleAnswer& truth = trial.truth[ray];
    Classification classification;
    classification.decided = truth.kind != OracleAnswer::undecidable;
    classification.differs = answer.differs;
    if (!classification.decided) return classification;
    const bool is_hit = truth.kind == OracleAnswer::hit;
    classification.wrong_class = answer.closest.has_value() != is_hit;
    classification.wrong_occlusion = answer.occluded != is_hit;
    if (answer.closest && is_hit) {
        classification.wrong_primitive = !is_nearest(*answer.closest, truth);
        const double error = error_of(answer.closest->t, truth);
        classification.wrong_t =
            !classification.wrong_primitive && error > largest_error(trial, ray, exact);
        classification.t_ulp = error / ulp_of_double(truth.t);
    }
    return classification;
}

}  // namespace etalon::crosscheck
