#include "core/bsdf/bsdf_from.h"

#include <algorithm>

namespace etalon {
namespace {

constexpr bool is_specular(LobeKind kind) {
    return kind == LobeKind::specular;
}

template <class SmoothLobe>
constexpr bool is_one_sided =
    SmoothLobe::kind == LobeKind::reflection || SmoothLobe::kind == LobeKind::transmission;

/// Returns the index on the other side over that on the side of `wo` if the lobe transmits light.
template <class SmoothLobe>
float index_beyond(const SmoothLobe& lobe, const Vec3f& wo) {
    if constexpr (requires { lobe.eta; }) return wo.z > 0 ? lobe.eta : 1 / lobe.eta;
    return 1;
}

float albedo_of(const Lobe& lobe, const Vec3f& wo) {
    return visit_lobe([&](const auto& kind) { return mean(kind.albedo(wo)); }, lobe);
}

}  // namespace

BsdfFrom::BsdfFrom(const BsdfFrame& frame, const LobeList& lobes, const Vec3& wo)
    : frame_(frame),
      lobes_(lobes),
      exact_wo_(frame.to_local(wo)),
      wo_(exact_wo_),
      above_(wo.dot(frame.ng)) {
    if (lobes.size() == 1) {
        picks_[0] = 1;
        return;
    }
    float total = 0;
    for (std::size_t k = 0; k < lobes.size(); ++k) total += picks_[k] = albedo_of(lobes[k], wo_);
    const float scale = total > 0 ? 1 / total : 0;
    for (std::size_t k = 0; k < lobes.size(); ++k) picks_[k] *= scale;
}

/// Returns the lobe for `choice` in [0, 1), one with a probability above 0 if there is any.
std::size_t BsdfFrom::chosen(float choice) const {
    std::size_t last = 0;
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
        if (picks_[k] == 0) continue;
        last = k;
        choice -= picks_[k];
        if (choice < 0) break;
    }
    return last;
}

LobeKind BsdfFrom::side(const Vec3& wi) const {
    return wi.dot(frame_.ng) * above_ > 0 ? LobeKind::reflection : LobeKind::transmission;
}

Evaluation BsdfFrom::evaluate_local(const Vec3f& wi, LobeKind side) const {
    Evaluation sum;
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
        visit_lobe(
            [&](const auto& lobe) {
                using L = std::decay_t<decltype(lobe)>;
                if constexpr (!is_specular(L::kind)) {
                    const Evaluation part = lobe.evaluate(wo_, wi);
                    if (scatters_to(side, L::kind)) sum.f += part.f;
                    if (!is_one_sided<L> || L::kind == side) sum.pdf += picks_[k] * part.pdf;
                }
            },
            lobes_[k]);
    }
    const bool is_turned = (wo_.z * wi.z > 0) != (side == LobeKind::reflection);
    if (is_turned) sum.pdf = turned_density(wi, side);
    return sum;
}

/// Returns the density of a direction between the horizons of both normals.
float BsdfFrom::turned_density(const Vec3f& wi, LobeKind side) const {
    float sum = 0;
    for (std::size_t k = 0; k < lobes_.size(); ++k) {
        visit_lobe(
            [&](const auto& lobe) {
                using L = std::decay_t<decltype(lobe)>;
                if constexpr (is_specular(L::kind))
                    return;
                else if constexpr (!is_one_sided<L>)
                    sum += picks_[k] * lobe.evaluate(wo_, wi).pdf;
                else if (L::kind == side)
                    sum += picks_[k] * lobe.evaluate(wo_, -wi).pdf;
            },
            lobes_[k]);
    }
    return sum;
}

/// Returns whether any lobe samples a local direction by the shading normal alone, as all lobes of
/// pbrt-v3 do. Between the horizons these are lobes of the other side.
bool BsdfFrom::is_sampled_unturned(const Vec3f& wi) const {
    const LobeKind by_shading = wo_.z * wi.z > 0 ? LobeKind::reflection : LobeKind::transmission;
    const auto samples = [&](const auto& lobe) {
        using L = std::decay_t<decltype(lobe)>;
        if constexpr (is_specular(L::kind)) {
            return false;
        } else {
            return scatters_to(by_shading, L::kind) && lobe.evaluate(wo_, wi).pdf > 0;
        }
    };
    return std::ranges::any_of(lobes_.span(),
                               [&](const Lobe& lobe) { return visit_lobe(samples, lobe); });
}

Evaluation BsdfFrom::evaluate(const Vec3& wi) const {
    if (wo_.z == 0 || lobes_.size() == 0) return {};
    return evaluate_local(Vec3f(frame_.to_local(wi)), side(wi));
}

std::optional<BsdfSample> BsdfFrom::sample_smooth(Vec3f local_wi,
                                                  std::optional<LobeKind> own_side) const {
    Vec3 wi = frame_.to_world(Vec3(local_wi));
    LobeKind where = side(wi);
    const bool turned = own_side && where != *own_side;
    if (turned) {
        wi = -wi;
        local_wi = -local_wi;
        where = side(wi);
    }
    const Evaluation e = evaluate_local(local_wi, where);
    if (!(e.pdf > 0) || is_black(e.f)) return {};
    const bool transmission = where == LobeKind::transmission;
    const bool only_lights = turned && !is_sampled_unturned(local_wi);
    return BsdfSample{wi, e.f, e.pdf, false, transmission, only_lights, 1};
}

std::optional<BsdfSample> BsdfFrom::sample_specular(
    float pick, const std::optional<SpecularSample>& chosen) const {
    if (!chosen || chosen->wi.z == 0) return {};
    const auto cos = static_cast<float>(std::abs(chosen->wi.z));
    return BsdfSample{frame_.to_world(chosen->wi),
                      chosen->weight / cos,
                      pick * chosen->probability,
                      true,
                      chosen->transmission,
                      false,
                      chosen->eta};
}

std::optional<BsdfSample> BsdfFrom::sample(float lobe_choice, const Vec2& uv) const {
    if (wo_.z == 0 || lobes_.size() == 0) return {};
    const std::size_t number = chosen(lobe_choice);
    return visit_lobe(
        [&](const auto& lobe) -> std::optional<BsdfSample> {
            using L = std::decay_t<decltype(lobe)>;
            if constexpr (is_specular(L::kind)) {
                return sample_specular(picks_[number], lobe.sample(exact_wo_, uv.x));
            } else {
                const std::optional<Vec3f> local_wi = lobe.sample(wo_, uv);
                if (!local_wi) return {};
                std::optional<LobeKind> own_side;
                if (is_one_sided<L>) own_side = L::kind;
                auto sampled = sample_smooth(*local_wi, own_side);
                if (sampled) sampled->eta = index_beyond(lobe, wo_);
                return sampled;
            }
        },
        lobes_[number]);
}

Color BsdfFrom::albedo() const {
    Color sum(0);
    for (const Lobe& lobe : lobes_.span()) {
        sum += visit_lobe([&](const auto& kind) { return kind.albedo(wo_); }, lobe);
    }
    return sum;
}

}  // namespace etalon
