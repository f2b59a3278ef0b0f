#pragma once

#include "core/intersect/ray.h"
#include "core/numerics/vec_columns.h"

namespace etalon {

/// A view of rays with tmin 0 as a structure of arrays. Values that all rays share are stored once.
struct RayStream {
    std::size_t size() const { return count; }
    bool empty() const { return count == 0; }

    Ray operator[](std::size_t i) const {
        Ray ray{origins[i], directions[i]};
        ray.tmax = tmax;
        ray.exclude = static_cast<HitKey>(excludes[i]);
        ray.traits_and_time = traits_and_time(i);
        return ray;
    }

    std::uint32_t traits_and_time(std::size_t i) const {
        return times == nullptr ? traits : traits | times[i] << Ray::time_shift;
    }

    RayStream subspan(std::size_t first, std::size_t some) const {
        RayStream part = *this;
        part.count = some;
        part.origins = origins.from(first);
        part.directions = directions.from(first);
        part.excludes = excludes + first;
        if (times != nullptr) part.times = times + first;
        return part;
    }
    RayStream subspan(std::size_t first) const { return subspan(first, count - first); }
    RayStream first(std::size_t some) const { return subspan(0, some); }

    std::size_t count = 0;
    Vec3Span origins, directions;        ///< padded
    const double* excludes;              ///< see Ray::exclude; padded
    const ShutterTime* times = nullptr;  ///< null: all at the time when the shutter opens
    double tmax = infinity;
    std::uint32_t traits = 0;  ///< see Ray::traits_and_time, without the time
};

/// Storage for the columns of a RayStream.
struct RayBuffer {
    void make_room(std::size_t count) {
        origins.make_room(count);
        directions.make_room(count);
        excludes.make_room(count);
    }

    void set(std::size_t i, const Ray& ray) {
        origins.set(i, ray.origin);
        directions.set(i, ray.direction);
        excludes[i] = static_cast<double>(ray.exclude);
    }

    /// Returns a view of the first `count` rays.
    RayStream view(std::size_t count) const {
        return {count, origins.span(), directions.span(), excludes.data()};
    }

    Vec3Buffer origins, directions;
    PaddedColumn<double> excludes;
};

}  // namespace etalon
