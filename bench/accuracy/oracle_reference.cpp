#include "bench/accuracy/oracle_reference.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/numerics/rounding.h"
#include "core/numerics/ulp.h"

namespace etalon::accuracy {
namespace {

/// Returns the point from which a renderer would continue the path.
Vec3 position(const Scene& scene, const TracerEntry& entry, const Ray& ray, const Answer& answer) {
    if (entry.refined) return surface_at(scene.geometry, ray, answer).position;
    return ray.origin + answer.t * ray.direction;
}

/// Returns the change of t when origin, direction and shape change by a relative u each: u (sum of
/// all magnitudes) / cosine.
double sensitivity(const hard::CaseSetup& setup, const Ray& ray, const OracleAnswer& reference) {
    const SurfacePoint p = surface_at(setup.scene.geometry, ray,
                                      {reference.t, reference.primitive, reference.instance});
    const double length = ray.direction.length();
    const double speed = std::abs(p.normal.dot(ray.direction)) - 4 * unit_roundoff * length;
    const double reach =
        max_abs(ray.origin) + max_abs(p.position) + setup.size + std::abs(reference.t) * length;
    return unit_roundoff * reach / std::max(speed, 0.0);
}

}  // namespace

OracleReference::OracleReference(const hard::CaseSetup& setup, const Oracle& oracle, const Ray& ray)
    : setup_(setup), ray_(ray), answer_(oracle.closest(ray, setup.tie)) {
    if (answer_.kind != OracleAnswer::hit) return;
    sensitivity_ = sensitivity(setup, ray, answer_);
    t_ = Remainder(answer_.exact_t);
    for (int k = 0; k < 3; ++k) {
        position_[k] = Remainder(Quad(ray.origin[k]) + answer_.exact_t * Quad(ray.direction[k]));
    }
}

void OracleReference::classify(const TracerEntry& entry, const Answer& answer,
                               ErrorStats& stats) const {
    ++stats.rays;
    const bool hit = answer.primitive != no_index;
    if (answer_.kind == OracleAnswer::undecidable) {
        ++stats.undecidable;
    } else if (answer_.kind == OracleAnswer::miss) {
        stats.false_hits += hit;
    } else if (!hit) {
        ++stats.false_misses;
    } else {
        const bool is_right = is_right_primitive(entry, answer);
        stats.wrong_primitives += !is_right;
        stats.wrong_roots += is_right && t_.distance(answer.t) > largest_error(entry);
        classify_distance(entry, answer, stats);
    }
}

void OracleReference::classify_distance(const TracerEntry& entry, const Answer& answer,
                                        ErrorStats& stats) const {
    const double off = t_.distance(answer.t);
    stats.float_ulps.add(off / ulp_of_float(answer_.t));
    stats.double_ulps.add(off / ulp_of_double(answer_.t));
    stats.conditioned.add(off / sensitivity_);
    const Vec3 p = position(setup_.scene, entry, ray_, answer);
    const Vec3 apart(position_[0].distance(p.x), position_[1].distance(p.y),
                     position_[2].distance(p.z));
    stats.position.add(apart.length() / setup_.size);
}

double OracleReference::largest_error(const TracerEntry& entry) const {
    return entry.exact ? answer_.exact_limit(setup_.tie) : answer_.root_limit(ray_, setup_.size);
}

bool OracleReference::is_right_primitive(const TracerEntry& entry, const Answer& answer) const {
    const auto& tied = answer_.tied;
    if (tied.size() == 1 || !entry.exact) {
        return std::binary_search(tied.begin(), tied.end(),
                                  key_of(answer.primitive, answer.instance));
    }
    return key_of(answer.primitive, answer.instance) == lowest_of_the_nearest();
}

/// Returns the primitive that the rule for ties selects among those that the oracle cannot
/// distinguish.
HitKey OracleReference::lowest_of_the_nearest() const {
    HitKey lowest = key_of(no_index, no_index);
    double t = ray_.tmax;
    for (const HitKey key : answer_.tied) {  // in ascending order
        const double at = first_hit(setup_.scene.geometry, key, ray_);
        const bool is_first = lowest == key_of(no_index, no_index) && at <= t;
        if (is_first || at < t) t = at, lowest = key;
    }
    return lowest;
}

}  // namespace etalon::accuracy
