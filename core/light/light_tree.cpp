#include "core/light/light_tree.h"

#include <algorithm>
#include <cmath>

#include "core/scene/geometry.h"

namespace etalon {
namespace {

struct Angle {
    double cosine, sine;
};

/// Returns the difference of two angles between 0 and pi, at least 0.
Angle difference(const Angle& a, const Angle& b) {
    if (a.cosine >= b.cosine) return {1, 0};
    return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

Angle of_cosine(double cosine) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    return {c, std::sqrt(1 - c * c)};
}

/// Clamps to values that can still be added and divided: near a point light there is no bound.
double at_most_largest(double importance) {
    constexpr double largest = 1e150;
    return importance < largest ? importance : largest;
}

}  // namespace

double LightTree::importance(const Node& node, const Receiver& at) {
    const Vec3 to_centre = node.centre - at.position;
    const double distance2 = to_centre.dot(to_centre),
                 radius2 = static_cast<double>(node.radius) * node.radius;
    if (!(distance2 > radius2)) return at_most_largest(node.intensity / radius2);
    const double inverse = 1 / std::sqrt(distance2);
    const double sine2 = radius2 * inverse * inverse;
    const Angle size{std::sqrt(1 - sine2), node.radius * inverse};
    const double along = -inverse * (node.axis[0] * to_centre.x + node.axis[1] * to_centre.y +
                                     node.axis[2] * to_centre.z);
    const Angle spread{node.cos_spread, node.sin_spread};
    const Angle off = of_cosine(node.two_sided ? std::abs(along) : along);
    const double emitted = difference(difference(off, spread), size).cosine;
    if (emitted < node.cos_emission) return 0;
    // Beyond a right angle a spotlight's falloff to an angle of cosine -k is at most k / 16.
    const double least = -node.cos_emission / 16;
    double received = 1;
    if (at.normal != Vec3(0)) {
        received = difference(of_cosine(inverse * at.normal.dot(to_centre)), size).cosine;
        if (received <= 0) return 0;
    }
    return at_most_largest(node.intensity * std::max(emitted, least) * received * inverse *
                           inverse);
}

double LightTree::importance(const Receiver& at) const {
    return nodes_.empty() ? 0 : importance(nodes_.front(), at);
}

double LightTree::first_share(const Node& node, const Receiver& at) const {
    const double a = importance(nodes_[node.first], at), b = importance(nodes_[node.first + 1], at);
    return a + b > 0 ? a / (a + b) : -1;
}

std::optional<LightPick> LightTree::pick(const Receiver& at, double choice) const {
    if (nodes_.empty()) return std::nullopt;
    const Node* node = &nodes_.front();
    double probability = 1;
    while (!node->is_leaf) {
        const double share = first_share(*node, at);
        if (share < 0) return std::nullopt;
        const bool is_first = choice < share;
        const double part = is_first ? share : 1 - share;
        choice = std::clamp((is_first ? choice : choice - share) / part, 0.0, 1 - 0x1p-53);
        probability *= part;
        node = &nodes_[node->first + (is_first ? 0 : 1)];
    }
    return LightPick{node->first, probability};
}

double LightTree::probability(const Receiver& at, std::uint32_t light) const {
    std::uint32_t node = leaves_[light];
    if (node == no_index) return 0;
    double probability = 1;
    for (std::uint32_t parent; (parent = parents_[node]) != no_index; node = parent) {
        const double share = first_share(nodes_[parent], at);
        if (share < 0) return 0;
        probability *= node == nodes_[parent].first ? share : 1 - share;
    }
    return probability;
}

}  // namespace etalon
