#pragma once

#include <algorithm>

#include "core/accel/clusters/cluster.h"
#include "native_accel/grid/cost.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

/// Pack of up to eight spheres in normalized space, rounded to float.
struct alignas(32) SpherePack {
    using Item = SphereItem;
    static constexpr GridCost cost{cluster_lanes, 1, 2, 12};

    /// Leaves all lanes unused: no distance is below a limit of -1.
    SpherePack() : centre{}, ids{} { limit.fill(-1); }

    void set(std::size_t lane, const SphereItem& item);

    /// Returns the number of spheres.
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::count_if(limit.begin(), limit.end(), [](float l) { return l >= 0; }));
    }

    std::array<Lanes, 3> centre;
    Lanes limit;  ///< largest squared distance of a ray from the centre that passes the filter
    std::array<std::uint32_t, cluster_lanes> ids;  ///< numbers in Geometry::primitives
};

/// Returns the square of a reach, for the distance of a centre from the ray as a vector in a plane
/// perpendicular to the ray: see SpherePackFilter. Its error, for u = 2^-24, |c| <= sqrt(3), |o| <=
/// 3 sqrt(3) and so |c - o| <= 7, is less than 40 u:
///   the ray's origin and direction are off by 3.7 u and 7 u;
///   each of two coordinates is off by 6.1 u for its axis, which is off by 0.87 u; 0.9 u for the
///     centre; 4 u for the origin's coordinate; 5.2 u for three products and two sums of at most
///     sqrt(3), and u for the last difference, at most the radius: 17.2 u, of both 24.4 u;
///   2 u for the roundings of squares and sum, as the distance is at most the radius.
inline float squared_reach(double radius) {
    const double reach = radius + 40 * unit_roundoff_f;
    return float_up(reach * reach);
}

inline void SpherePack::set(std::size_t lane, const SphereItem& item) {
    for (int k = 0; k < 3; ++k) centre[k][lane] = static_cast<float>(item.centre[k]);
    limit[lane] = squared_reach(item.radius);
    ids[lane] = item.id;
}

}  // namespace etalon
