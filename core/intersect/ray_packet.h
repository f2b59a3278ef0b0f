#pragma once

#include <algorithm>
#include <array>

#include "core/intersect/ray_columns.h"

namespace etalon {

/// A packet of rays of one dominant axis, as a structure of arrays, with their nearest hits. It is
/// small enough for the data that kernels need to stay in the L1 cache.
class RayPacket {
  public:
    static constexpr std::size_t most = RayColumns::most;

    /// Primitive number of a miss. Primitive numbers are doubles here, so that vector instructions
    /// can compare them in the same lanes as the distances.
    static constexpr double none = infinity;

    template <class T>
    using Column = RayColumns::Column<T>;

    RayPacket() = default;
    RayPacket(const RayPacket&) = delete;
    RayPacket& operator=(const RayPacket&) = delete;

    int dominant = 0;  ///< dominant axis of all directions
    std::size_t count = 0;
    Vec3Span origins{};
    Vec3Span directions{};  ///< as in a RayQuery
    const double *tmins = nullptr, *excludes = nullptr;
    Column<double> ts, primitives;  ///< nearest hits; at first tmax and `none`
    Column<std::uint32_t> numbers;  ///< numbers of the rays in their batch
    Column<std::uint32_t> traits_and_times;

    /// Adds a ray to a packet that was empty before the first was added. `direction` is that of its
    /// RayQuery.
    void add(std::size_t number, const Ray& ray, const Vec3& direction) {
        if (count == 0) use_own();
        const std::size_t i = count++;
        own_origins_.set(i, ray.origin);
        own_directions_.set(i, direction);
        own_tmins_[i] = std::max(ray.tmin, 0.0);
        own_excludes_[i] = static_cast<double>(ray.exclude);
        ts[i] = ray.tmax;
        primitives[i] = none;
        numbers[i] = static_cast<std::uint32_t>(number);
        traits_and_times[i] = ray.traits_and_time;
    }

    /// Sets the packet to common rays of the same dominant axis, numbered from `first` on.
    /// `columns` are those of `all` and must outlive the packet's use.
    void set(std::size_t first, std::span<const Ray> all, const RayColumns& columns) {
        set(first, columns);
        for (std::size_t i = 0; i < count; ++i) {
            own_tmins_[i] = std::max(columns.tmins[i], 0.0);
            own_excludes_[i] = static_cast<double>(all[i].exclude);
            traits_and_times[i] = all[i].traits_and_time;
        }
        tmins = own_tmins_.data();
        excludes = own_excludes_.data();
    }
    void set(std::size_t first, const RayStream& all, const RayColumns& columns) {
        set(first, columns);
        tmins = columns.tmins.data();
        excludes = all.excludes;
        traits_and_times.fill(all.traits);
        if (all.times == nullptr) return;
        for (std::size_t i = 0; i < count; ++i) traits_and_times[i] = all.traits_and_time(i);
    }

    /// Removes the rays that have hit something and calls tell(number) for each.
    template <class Tell>
    void remove_hit(const Tell& tell) {
        for (std::size_t i = count; i-- > 0;) {
            if (primitives[i] == none) continue;
            tell(numbers[i]);
            remove(i);
        }
    }

    Hit hit(std::size_t i) const {
        const double p = primitives[i];
        return {ts[i], p == none ? no_index : static_cast<std::uint32_t>(p)};
    }

    /// Returns a ray with its tmax at its nearest hit.
    Ray ray(std::size_t i) const {
        Ray ray{origins[i], directions[i], tmins[i], ts[i]};
        ray.exclude = static_cast<HitKey>(excludes[i]);
        ray.traits_and_time = traits_and_times[i];
        return ray;
    }

  private:
    void set(std::size_t first, const RayColumns& columns) {
        dominant = static_cast<int>(columns.dominants[0]);
        count = columns.count;
        origins = columns.origins;
        directions = columns.directions;
        ts = columns.tmaxs;
        primitives.fill(none);
        for (std::size_t i = 0; i < most; ++i) numbers[i] = static_cast<std::uint32_t>(first + i);
    }

    void use_own() {
        origins = own_origins_.span();
        directions = own_directions_.span();
        tmins = own_tmins_.data();
        excludes = own_excludes_.data();
    }

    /// Makes the columns the packet's own, which can be changed.
    void take_columns() {
        if (origins.x == own_origins_.x.data()) return;
        own_origins_.copy(origins, count);
        own_directions_.copy(directions, count);
        if (tmins != own_tmins_.data()) std::copy_n(tmins, count, own_tmins_.begin());
        if (excludes != own_excludes_.data()) std::copy_n(excludes, count, own_excludes_.begin());
        use_own();
    }

    /// Removes a ray; the last one takes its place.
    void remove(std::size_t i) {
        take_columns();
        const std::size_t last = --count;
        own_origins_.set(i, own_origins_[last]);
        own_directions_.set(i, own_directions_[last]);
        own_tmins_[i] = own_tmins_[last];
        own_excludes_[i] = own_excludes_[last];
        ts[i] = ts[last];
        primitives[i] = primitives[last];
        numbers[i] = numbers[last];
        traits_and_times[i] = traits_and_times[last];
    }

    Vec3Columns<most> own_origins_, own_directions_;
    Column<double> own_tmins_, own_excludes_;
};

}  // namespace etalon
