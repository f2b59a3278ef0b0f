// Surfaces that lie in the same place.
#pragma once

#include <vector>

#include "core/intersect/batch_intersector.h"

namespace etalon::test {

/// Takes of two surfaces in the same place the one that another intersector does not take, which
/// must outlive it. All other answers are that intersector's.
class OtherOfCoincident : public BatchIntersector {
  public:
    explicit OtherOfCoincident(const BatchIntersector& first) : first_(first) {}

    using BatchIntersector::closest, BatchIntersector::occluded;

    void closest(std::span<const Ray> rays, std::span<Hit> hits) const override {
        first_.closest(rays, hits);
        std::vector<Ray> behind(rays.begin(), rays.end());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            behind[i].exclude = hits[i].primitive;
            behind[i].tmin = hits[i].t * (1 - tolerance);
            behind[i].tmax = hits[i].t * (1 + tolerance);
        }
        std::vector<Hit> others(rays.size());
        first_.closest(behind, others);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].primitive != no_index && others[i].primitive != no_index) {
                hits[i] = others[i];
            }
        }
    }

    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        first_.occluded(rays, blocked);
    }

  private:
    /// Relative difference of t, some roundings of a float, that a renderer in floats may not see.
    static constexpr double tolerance = 0x1p-20;

    const BatchIntersector& first_;
};

}  // namespace etalon::test
