// Hits of a ray decided without a kernel: every primitive of the scene is tested in quad precision
// with error bounds, on the exact bits of the input. For tests and measurements.
#pragma once

#include <vector>

#include "core/intersect/ray.h"
#include "core/oracle/quad.h"
#include "core/scene/geometry.h"

namespace etalon {

struct OracleAnswer {
    enum Kind {
        hit,
        miss,
        undecidable  ///< even 113 bits cannot decide, or not at which distance
    };

    /// Returns |t - the true t| / |the true t|, for a hit.
    double relative_error(double t) const;

    /// Returns the largest |t - exact_t| of a right hit of an exact backend: t_tolerance, relative,
    /// and for one of several `tied` primitives how far they may be apart.
    double exact_limit(double tie = 2 * t_tolerance) const;

    /// Returns the largest |t - exact_t| that a lack of precision explains: beyond it, another root
    /// was found. That is a hundredth of `size`, half that of the scene or shape, along the ray,
    /// but at least an ulp of a float.
    double root_limit(const Ray& ray, double size) const;

    Kind kind = miss;
    double t = 0;                        ///< the double nearest to the true t
    Quad exact_t = 0;                    ///< good to about 100 bits, to 46 if it is ill-conditioned
    std::uint32_t primitive = no_index;  ///< primitive of the lowest key among `tied`
    std::uint32_t instance = no_index;   ///< likewise
    std::vector<HitKey> tied;            ///< primitives (maybe) hit at t, to within `tie`; sorted
};

struct FoundHits;

class Oracle {
  public:
    /// The scene must outlive the oracle.
    explicit Oracle(const Geometry& geometry);

    /// Returns the nearest hit with tmin < t <= tmax. Hits whose distances differ by less than
    /// `tie` times t count as equally near, since a kernel's rounding may put either first.
    OracleAnswer closest(const Ray& ray, double tie = 2 * t_tolerance) const;

  private:
    struct Candidate {
        double entry;  ///< a lower bound on the t of the hit
        std::uint32_t primitive;
    };
    std::vector<Candidate> candidates(const Ray& ray) const;
    void add_hits(const Ray& ray, double tie, std::uint32_t instance, FoundHits& hits) const;

    const Geometry& geometry_;
    std::vector<Oracle> objects_;  ///< oracles of the geometry's objects
    std::vector<Box3> boxes_;
    Box3 whole_;         ///< union of all boxes
    double extent_ = 0;  ///< largest coordinate of any finite box
};

}  // namespace etalon
