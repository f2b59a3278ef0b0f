// Primitives sorted into bins by their centres (Wald 2007, "On fast Construction of SAH-based
// Bounding Volume Hierarchies").
#pragma once

#include "core/accel/tree/bounds.h"
#include "core/accel/tree/leaf_cost.h"

namespace etalon {

inline constexpr int max_bins = 32;

/// Maps a centre to its bin along each axis, with the same arithmetic for counting and
/// partitioning.
class Binning {
  public:
    /// Divides the box `centres`, which contains all centres, into `bins` bins along each axis.
    Binning(const Bounds& centres, int bins);

    int bins() const { return bins_; }

    /// Returns whether the centres fall into more than one bin along the axis.
    bool divides(int axis) const { return scale_[axis] > 0; }

    /// Returns the bins along all axes.
    Bounds::Corner positions(const Bounds& b) const { return (twice_centre(b) - origin_) * scale_; }

    /// Returns whether the bin along `axis` is below `bin`.
    bool is_below(const Bounds& b, int axis, float bin) const {
        return (b.min[axis] + b.max[axis] - origin_[axis]) * scale_[axis] < bin;
    }

  private:
    Bounds::Corner origin_, scale_;
    int bins_;
};

/// Sums over the primitives of a bin.
struct Bin {
    void add(const Bounds& b, std::uint32_t primitive_weight) {
        bounds.extend(b);
        weight += primitive_weight;
        ++count;
    }
    void add(const Bin& other) {
        bounds.extend(other.bounds);
        weight += other.weight;
        count += other.count;
    }

    Bounds bounds;
    std::uint64_t weight = 0;
    std::uint32_t count = 0;
};

using BinsByAxis = std::array<std::array<Bin, max_bins>, 3>;

/// The bins of a set of primitives. Large, so it should be reused.
class Bins {
  public:
    /// Counts the primitives, after clearing the bins.
    void count(const Binning& binning, std::span<const BoundedPrimitive> primitives,
               const LeafWeights& weights);
    void add(const Bins& other);

    int size() const { return size_; }
    const Bin& at(int axis, int bin) const { return bins_[axis][bin]; }

    /// Returns the sum of the bins of an axis from `begin` to before `end`.
    Bin sum(int axis, int begin, int end) const;

  private:
    int size_ = 0;
    BinsByAxis bins_;
};

}  // namespace etalon
