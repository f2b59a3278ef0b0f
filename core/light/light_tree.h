#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/light/light_bounds.h"
#include "core/light/receiver.h"

namespace etalon {

/// A tree of lights, by which one of many is picked in about the logarithm of their number of
/// steps: at each node one of its two halves, by a bound on what it sends to the receiver (Conty
/// Estevez & Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting", without
/// the splitting).
class LightTree {
  public:
    /// Lights are known by their numbers in `bounds`; one without intensity is never picked.
    explicit LightTree(const std::vector<LightBounds>& bounds);

    /// About the irradiance that all lights together give the receiver if nothing is in the way; 0
    /// only where they give none.
    double importance(const Receiver& at) const;

    /// Picks a light; nothing where the bounds of those that are left, but not those of their
    /// clusters, say that they give no light.
    std::optional<LightPick> pick(const Receiver& at, double choice) const;

    /// The probability with which pick() picks the light.
    double probability(const Receiver& at, std::uint32_t light) const;

  private:
    /// Floats are rounded so that a bound stays one.
    struct alignas(64) Node {
        Vec3 centre;
        float radius;
        std::array<float, 3> axis;
        float cos_spread, sin_spread, cos_emission;
        float intensity;
        std::uint32_t first;  ///< of two children that follow each other; of a leaf, the light
        bool is_leaf, two_sided;
    };
    class Builder;

    static Node node_of(const LightBounds& bounds);
    static double importance(const Node& node, const Receiver& at);
    /// Probability of the first of a node's halves; less than 0 if neither gives light.
    double first_share(const Node& node, const Receiver& at) const;

    std::vector<Node> nodes_;             ///< the root first
    std::vector<std::uint32_t> parents_;  ///< of nodes
    std::vector<std::uint32_t> leaves_;   ///< of lights; no_index for one that is not picked
};

}  // namespace etalon
