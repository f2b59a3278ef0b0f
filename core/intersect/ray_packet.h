#pragma once

#include <array>

#include "core/intersect/ray_columns.h"

namespace etalon {

/// Rays of one dominant axis, side by side, that look for their nearest hits together. So many that
/// what kernels need of them stays in the fastest cache.
struct RayPacket {
    static constexpr std::size_t most = RayColumns::most;

    /// Number of no primitive. Numbers are doubles here, so that vector instructions can compare
    /// them together with the rest.
    static constexpr double none = infinity;

    template <class T>
    using Column = std::array<T, most>;

    int dominant = 0;  ///< the axis that is the dominant one of all
    std::size_t count = 0;
    Column<const Ray*> rays;
    Vec3Columns<most> origins, directions;  ///< as in a RayQuery
    Column<double> tmins, excludes;
    Column<double> ts, primitives;  ///< of the nearest hits; at first the ray's tmax, and none

    /// `direction`: the ray's as a RayQuery has it.
    void add(const Ray& ray, const Vec3& direction) {
        const std::size_t i = count++;
        rays[i] = &ray;
        origins.set(i, ray.origin);
        directions.set(i, direction);
        tmins[i] = std::max(ray.tmin, 0.0);
        excludes[i] = ray.exclude == no_index ? none : ray.exclude;
        ts[i] = ray.tmax;
        primitives[i] = none;
    }

    /// Sets the packet to rays whose columns are known: common ones of the same dominant axis.
    void set(std::span<const Ray> all, const RayColumns& columns) {
        dominant = static_cast<int>(columns.dominants[0]);
        count = all.size();
        origins = columns.origins;
        directions = columns.directions;
        ts = columns.tmaxs;
        primitives.fill(none);
        for (std::size_t i = 0; i < count; ++i) {
            rays[i] = &all[i];
            tmins[i] = std::max(columns.tmins[i], 0.0);
            excludes[i] = all[i].exclude == no_index ? none : all[i].exclude;
        }
    }

    /// Removes a ray; the last takes its place.
    void remove(std::size_t i) {
        const std::size_t last = --count;
        rays[i] = rays[last];
        origins.set(i, origins[last]);
        directions.set(i, directions[last]);
        tmins[i] = tmins[last];
        excludes[i] = excludes[last];
        ts[i] = ts[last];
        primitives[i] = primitives[last];
    }

    /// Removes the rays that have hit something, and tells of each.
    template <class Tell>
    void remove_hit(const Tell& tell) {
        for (std::size_t i = count; i-- > 0;) {
            if (primitives[i] == none) continue;
            tell(rays[i]);
            remove(i);
        }
    }

    Hit hit(std::size_t i) const {
        const double p = primitives[i];
        return {ts[i], p == none ? no_index : static_cast<std::uint32_t>(p)};
    }
};

}  // namespace etalon
