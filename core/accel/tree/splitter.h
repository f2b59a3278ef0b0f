#pragma once

#include <optional>

#include "core/accel/tree/builder.h"
#include "core/accel/tree/partition.h"

namespace etalon {

/// Decides how sets of primitives are divided, and which become leaves.
class Splitter {
  public:
    Splitter(const BvhConfig& config, const LeafWeights& weights)
        : config_(config), weights_(weights) {}

    /// Splits a set `depth` levels below the root by reordering its primitives. Returns nothing if
    /// it becomes a leaf.
    std::optional<SplitSets> split(const PrimitiveSet& set, int depth);

  private:
    bool fills_one_test(const PrimitiveSet& set) const;
    Split cheapest(const PrimitiveSet& set, const Binning& binning);
    SplitSides sides_of(const PrimitiveSet& set, const Binning& binning, const Split& split) const;
    bool pays(const Split& split, const PrimitiveSet& set) const;

    const BvhConfig& config_;
    const LeafWeights& weights_;
    Bins bins_;
};

/// Returns the number of bins, which is smaller for few primitives.
int bins_for(std::size_t primitives, const BvhConfig& config);

}  // namespace etalon
