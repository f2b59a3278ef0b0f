// Choice of the light to sample at a point, by the lights' unoccluded contributions.
#include <algorithm>
#include <array>
#include <numbers>

#include "core/light/lights.h"
#include "core/light/strength.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

/// Returns approximately the unoccluded irradiance of a light at the point, never 0 where there is
/// any.
double Lights::importance(const Source& source, const Receiver& at) const {
    if (std::holds_alternative<InfiniteSource>(*source.light)) {
        return source.power / (pi * scene_radius_ * scene_radius_);
    }
    const bool one_sided = at.normal != Vec3(0);
    if (std::holds_alternative<AreaSource>(*source.light)) {
        const AreaLight& light = area_lights_[source.index];
        const auto& [centre, radius] = light.bounds;
        const Vec3 to_centre = centre - at.position;
        const double distance2 = std::max(to_centre.dot(to_centre), radius * radius);
        const double cosine = one_sided ? largest_cosine(at.normal, to_centre, radius) : 1;
        return light.exitance * cosine * light.facing(-to_centre) / distance2;
    }
    const LightSample sample = sample_delta(source, at.position);
    const double cosine = one_sided ? std::max(0.0, at.normal.dot(sample.wi)) : 1;
    const double importance = strength(sample.radiance) * cosine;
    // Where an image is infinite or no number, the light is picked beside the others, so that its
    // samples are counted as such.
    return std::isfinite(importance) ? importance : source.power;
}

std::optional<LightPick> Lights::pick(Receiver& at, double choice) const {
    if (tree_) return pick_from_tree(at, choice);
    if (sources_.size() == 1) return LightPick{0, 1};
    std::array<double, most_by_importance> sums;
    double sum = 0;
    for (std::size_t i = 0; i < sources_.size(); ++i) sums[i] = sum += importance(sources_[i], at);
    at.total_importance = sum;
    if (!(sum > 0)) return std::nullopt;
    const double wanted = choice * sum;
    std::uint32_t light = 0;
    while (light + 1 < sources_.size() && sums[light] <= wanted) ++light;
    while (light > 0 && sums[light] == sums[light - 1]) --light;
    return LightPick{light, (sums[light] - (light == 0 ? 0 : sums[light - 1])) / sum};
}

/// First chooses between the tree and the lights at infinity: half by importance, half uniformly,
/// so that neither is lost where the bound of the whole tree is far from its contribution; then in
/// either.
std::optional<LightPick> Lights::pick_from_tree(Receiver& at, double choice) const {
    double far = 0;
    for (const std::uint32_t light : far_) far += importance(sources_[light], at);
    const double near = tree_->importance(at);
    at.total_importance = far;
    if (!(far + near > 0)) return std::nullopt;
    at.tree_probability = far > 0 && near > 0 ? (near / (far + near) + 0.5) / 2 : near > 0 ? 1 : 0;
    if (choice < at.tree_probability) {
        auto picked = tree_->pick(at, choice / at.tree_probability);
        if (picked) picked->probability *= at.tree_probability;
        return picked;
    }
    const double part = 1 - at.tree_probability;
    double wanted = (choice - at.tree_probability) / part * far;
    std::optional<LightPick> picked;
    for (const std::uint32_t light : far_) {
        const double own = importance(sources_[light], at);
        if (!(own > 0)) continue;
        picked = {light, own / far * part};
        if ((wanted -= own) < 0) break;
    }
    return picked;
}

LightPick Lights::pick_point_light(double choice) const {
    const double sum = point_power_sums_.back();
    const auto found = std::ranges::upper_bound(point_power_sums_, choice * sum);
    const std::ptrdiff_t number =
        std::min<std::ptrdiff_t>(found - point_power_sums_.begin(), std::ssize(point_lights_) - 1);
    const std::uint32_t light = point_lights_[static_cast<std::size_t>(number)];
    return {light, sources_[light].power / sum};
}

double Lights::point_light_probability(std::uint32_t light) const {
    const bool is_one = std::ranges::binary_search(point_lights_, light);
    return is_one ? sources_[light].power / point_power_sums_.back() : 0;
}

double Lights::pick_probability(const Receiver& at, std::uint32_t light) const {
    if (sources_.size() == 1) return 1;
    if (!tree_) {
        return at.total_importance > 0 ? importance(sources_[light], at) / at.total_importance : 0;
    }
    if (!std::ranges::binary_search(far_, light)) {
        return at.tree_probability > 0 ? tree_->probability(at, light) * at.tree_probability : 0;
    }
    if (!(at.total_importance > 0)) return 0;
    return importance(sources_[light], at) / at.total_importance * (1 - at.tree_probability);
}

}  // namespace etalon
