#pragma once

#include <optional>

#include "core/accel/tree/builder.h"
#include "core/accel/tree/partition.h"

namespace etalon {

/// Decides where sets of primitives are divided, and where they end as leaves.
class Splitter {
  public:
    Splitter(const BvhConfig& config, const LeafWeights& weights)
        : config_(config), weights_(weights) {}

    /// Reorders the primitives of a set `depth` levels below the root; nothing makes it a leaf.
    std::optional<SplitSets> split(const PrimitiveSet& set, int depth);

  private:
    bool fills_one_test(const PrimitiveSet& set) const;
    bool pays(const Split& split, const PrimitiveSet& set) const;

    const BvhConfig& config_;
    const LeafWeights& weights_;
    Bins bins_;
};

/// Number of bins: fewer where there are few primitives to tell apart.
int bins_for(std::size_t primitives, const BvhConfig& config);

}  // namespace etalon
