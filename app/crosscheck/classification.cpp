#include "app/crosscheck/classification.h"

#include <algorithm>
#include <cmath>

namespace etalon::crosscheck {
namespace {

double error_in_ulp(double t, const OracleAnswer& truth) {
    const double ulp = std::nextafter(truth.t, infinity) - truth.t;
    return static_cast<double>(magnitude(Quad(t) - truth.exact_t) / Quad(ulp));
}

bool is_nearest(const Hit& hit, const OracleAnswer& truth) {
    return std::binary_search(truth.tied.begin(), truth.tied.end(),
                              key_of(hit.primitive, hit.instance));
}

}  // namespace

Classification classify(const OracleAnswer& truth, const Answer& answer) {
    Classification classification;
    classification.decided = truth.kind != OracleAnswer::undecidable;
    classification.differs = answer.differs;
    if (!classification.decided) return classification;
    const bool is_hit = truth.kind == OracleAnswer::hit;
    classification.wrong_class = answer.closest.has_value() != is_hit;
    classification.wrong_occlusion = answer.occluded != is_hit;
    if (answer.closest && is_hit) {
        classification.wrong_primitive = !is_nearest(*answer.closest, truth);
        classification.t_ulp = error_in_ulp(answer.closest->t, truth);
    }
    return classification;
}

}  // namespace etalon::crosscheck
