#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/light/light_bounds.h"
#include "core/light/receiver.h"

namespace etalon {

/// A tree of lights from which one of many is picked in about logarithmically many steps. At each
/// node one of its two halves is chosen by a bound on what it sends to the receiver (Conty Estevez
/// & Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting", without the
/// splitting).
class LightTree {
  public:
    /// Lights are identified by their indices in `bounds`; one without intensity is never picked.
    explicit LightTree(const std::vector<LightBounds>& bounds);

    /// Returns approximately the unoccluded irradiance of all lights at the receiver; 0 only if
    /// they give none.
    double importance(const Receiver& at) const;

    /// Picks a light. Returns nothing if the bounds of the remaining lights, but not those of their
    /// clusters, show that they give no light.
    std::optional<LightPick> pick(const Receiver& at, double choice) const;

    /// Returns the probability with which pick() picks the light.
    double probability(const Receiver& at, std::uint32_t light) const;

  private:
    /// A node; its floats are rounded so that bounds stay bounds.
    struct alignas(64) Node {
        Vec3 centre;
        float radius;
        std::array<float, 3> axis;
        float cos_spread, sin_spread, cos_emission;
        float intensity;
        std::uint32_t first;  ///< the first of two adjacent children; in a leaf, the light
        bool is_leaf, two_sided;
    };
    class Builder;

    static Node node_of(const LightBounds& bounds);
    static double importance(const Node& node, const Receiver& at);
    /// Returns the probability of the first of a node's halves; negative if neither gives light.
    double first_share(const Node& node, const Receiver& at) const;

    std::vector<Node> nodes_;             ///< the root first
    std::vector<std::uint32_t> parents_;  ///< parent of each node
    std::vector<std::uint32_t> leaves_;   ///< leaf of each light; no_index if it is never picked
};

}  // namespace etalon
