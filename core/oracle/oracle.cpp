#include "core/oracle/oracle.h"

#include <optional>

#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/intersect/rescaled_ray.h"
#include "core/numerics/ulp.h"
#include "core/oracle/definitions.h"
#include "core/oracle/enclosure.h"

namespace etalon {
namespace {

Certainty is_visible(const Crossing& c, Sides sides) {
    if (sides == Sides::both || sides == Sides::cut_out) return Certainty::yes;
    return sides == Sides::front ? c.front : !c.front;
}

/// A kernel compares its rounded t with the ray's ends, and has no t beyond the range of double. It
/// cannot distinguish values below that range from 0, but it can recognise 0 itself.
Certainty is_within(const Crossing& c, const Ray& ray, double tie) {
    const auto rounded = [tie](const Tracked& t) {
        const bool is_zero = t.value == 0 && t.error == 0;
        const Quad least = is_zero ? 0 : std::numeric_limits<double>::min();
        return Tracked(t.value, t.error + magnitude(t.value) * Quad(tie) + least);
    };
    const Tracked start = std::max(ray.tmin, 0.0),
                  end = std::min(ray.tmax, std::numeric_limits<double>::max());
    return (start < rounded(c.t)) & (start < rounded(c.passage)) & (rounded(c.t) <= end);
}

}  // namespace

struct FoundHit {
    Tracked t;
    Certainty exists;
    HitKey key;
};

/// Crossings so far, with the nearest certain one.
struct FoundHits {
    void add(const FoundHit& m) {
        all.push_back(m);
        if (m.exists == Certainty::yes && (!nearest || m.t.value < nearest->t.value)) nearest = m;
    }

    std::vector<FoundHit> all;
    std::optional<FoundHit> nearest;
};

namespace {

/// Largest relative error of an answer's t: far below that of any kernel.
constexpr double finest_error = 0x1p-10 * t_tolerance;

OracleAnswer answer_from(const FoundHits& hits, double tie) {
    OracleAnswer answer;
    const auto& nearest = hits.nearest;
    for (const FoundHit& m : hits.all) {
        // A root of a shape that may not exist is not as good as the next.
        const bool is_other_root = nearest && m.exists != Certainty::yes && m.key == nearest->key &&
                                   m.t.value < nearest->t.value;
        const bool tied =
            nearest && magnitude(m.t.value - nearest->t.value) + m.t.error <=
                           magnitude(nearest->t.value) * Quad(tie) + 2 * nearest->t.error;
        if (tied && !is_other_root) {
            answer.tied.push_back(m.key);
        } else if (!nearest || m.t.value - m.t.error <= nearest->t.value) {
            answer.kind = OracleAnswer::undecidable;
            return answer;
        }
    }
    if (!nearest) return answer;
    if (nearest->t.error > magnitude(nearest->t.value) * Quad(finest_error)) {
        answer.kind = OracleAnswer::undecidable;
        return answer;
    }
    std::sort(answer.tied.begin(), answer.tied.end());
    answer.tied.erase(std::unique(answer.tied.begin(), answer.tied.end()), answer.tied.end());
    answer.kind = OracleAnswer::hit;
    answer.exact_t = nearest->t.value;
    answer.t = static_cast<double>(nearest->t.value);
    answer.primitive = static_cast<std::uint32_t>(answer.tied.front());
    answer.instance = static_cast<std::uint32_t>(answer.tied.front() >> 32) - 1;
    return answer;
}

/// Slab test with a margin far above its own roundings and those of a bounding box.
class WideSlabs {
  public:
    WideSlabs(const Ray& ray, double extent) : ray_(ray) {
        const double margin = 0x1p-30 * (extent + max_abs(ray.origin));
        const double least = 0x1p-60 * max_abs(ray.direction);
        for (int k = 0; k < 3; ++k) {
            const double d = ray.direction[k];
            inverse_[k] = 1 / (std::abs(d) < least ? std::copysign(least, d) : d);
            slack_[k] = margin * std::abs(inverse_[k]);
        }
    }

    /// Returns a t at which the ray has not yet entered the box, if it may cross it.
    std::optional<double> entry(const Box3& box) const {
        double entry = -infinity, exit = infinity;
        for (int k = 0; k < 3; ++k) {
            const double a = (box.min[k] - ray_.origin[k]) * inverse_[k];
            const double b = (box.max[k] - ray_.origin[k]) * inverse_[k];
            entry = std::max(entry, std::min(a, b) - slack_[k]);
            exit = std::min(exit, std::max(a, b) + slack_[k]);
        }
        if (entry <= exit && exit >= ray_.tmin && entry <= ray_.tmax) return entry;
        return std::nullopt;
    }

  private:
    const Ray& ray_;
    Vec3 inverse_, slack_;
};

}  // namespace

double OracleAnswer::relative_error(double t_measured) const {
    return static_cast<double>(magnitude(Quad(t_measured) - exact_t) / magnitude(exact_t));
}

/// A t below the range of double may be off by any fraction of it.
double OracleAnswer::exact_limit(double tie) const {
    const double relative = t_tolerance + finest_error + (tied.size() > 1 ? tie : 0);
    return relative * t + std::numeric_limits<double>::min();
}

double OracleAnswer::root_limit(const Ray& ray, double size) const {
    constexpr double other_root = 1e-2;
    return std::max(other_root * size / ray.direction.length(), ulp_of_float(t));
}

Oracle::Oracle(const Geometry& geometry) : geometry_(geometry) {
    const Box3 everywhere(Vec3(-infinity), Vec3(infinity));
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        const Box3 box = enclosure(geometry, id);
        const bool finite = !box.isEmpty() && is_finite(box.min) && is_finite(box.max);
        boxes_.push_back(finite ? box : everywhere);
        whole_.extendBy(boxes_.back());
        if (finite) extent_ = std::max({extent_, max_abs(box.min), max_abs(box.max)});
    }
    for (const Geometry& object : geometry.objects) objects_.emplace_back(object);
}

/// Returns the primitives whose boxes the ray may hit, the nearest first.
std::vector<Oracle::Candidate> Oracle::candidates(const Ray& ray) const {
    const WideSlabs slabs(ray, extent_);
    std::vector<Candidate> found;
    if (!slabs.entry(whole_)) return found;
    for (std::uint32_t id = 0; id < boxes_.size(); ++id) {
        if (const auto entry = slabs.entry(boxes_[id])) found.push_back({*entry, id});
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.entry < b.entry; });
    return found;
}

/// Adds hits on the primitives of an instance, whose object this is, or on all primitives. Holes
/// are decided by the kernels' function. What a ray excludes of the scene is tested all the same,
/// since it should miss it; of an instance, the roundings of its way into the object might decide.
void Oracle::add_hits(const Ray& ray, double tie, std::uint32_t instance, FoundHits& hits) const {
    if (!is_valid(ray)) return;
    const RayQuery query(ray);
    const std::uint32_t left = instance == no_index ? no_index : ray.excluded();
    for (const Candidate& candidate : candidates(ray)) {
        if (hits.nearest && Quad(candidate.entry) > hits.nearest->t.value) break;
        if (candidate.primitive == left) continue;
        const Sides sides = geometry_.primitives[candidate.primitive].sides;
        for (const Crossing& c : crossings(geometry_, candidate.primitive, ray)) {
            const Certainty exists = c.exists & is_visible(c, sides) & is_within(c, ray, tie);
            if (exists == Certainty::no) continue;
            if (sides == Sides::cut_out && meets_hole(geometry_, candidate.primitive, query)) break;
            hits.add({c.t, exists, key_of(candidate.primitive, instance)});
        }
    }
}

/// Objects are defined for rays of usual length: see RescaledRay.
OracleAnswer Oracle::closest(const Ray& ray, double tie) const {
    if (!is_valid(ray)) return {};
    if (has_extreme_direction(ray)) {
        const RescaledRay usual(ray);
        OracleAnswer answer = closest(usual.ray, tie);
        answer.exact_t *= Quad(usual.unit);
        answer.t = static_cast<double>(answer.exact_t);
        return answer;
    }
    FoundHits hits;
    add_hits(ray, tie, no_index, hits);
    const Ray meant = RayQuery(ray).ray;
    for (std::uint32_t i = 0; i < geometry_.instances.size(); ++i) {
        const InstanceAt instance(geometry_, i, meant.time());
        objects_[instance->object].add_hits(to_object(*instance, i, meant), tie, i, hits);
    }
    return answer_from(hits, tie);
}

}  // namespace etalon
