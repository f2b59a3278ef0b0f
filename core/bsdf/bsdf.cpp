#include "core/bsdf/bsdf.h"

namespace etalon {
namespace {

constexpr bool is_specular(LobeKind kind) {
    return kind == LobeKind::specular;
}

template <class SmoothLobe>
constexpr bool is_diffuse = requires {
    SmoothLobe::is_diffuse;
};

/// The part of `tangent` orthogonal to the unit vector `n`, of unit length.
Vec3 orthonormal_tangent(const Vec3& n, const Vec3& tangent) {
    const Vec3 across = tangent - n.dot(tangent) * n;
    const double length2 = across.dot(across);
    if (length2 > 1e-12 * tangent.dot(tangent)) return across / std::sqrt(length2);
    Vec3 u, v;
    orthonormal_basis(n, u, v);
    return u;
}

/// Index on the other side over that on the side of `wo` where the lobe lets light through.
template <class SmoothLobe>
float index_beyond(const SmoothLobe& lobe, const Vec3f& wo) {
    if constexpr (requires { lobe.eta; }) return wo.z > 0 ? lobe.eta : 1 / lobe.eta;
    return 1;
}

float albedo_of(const Lobe& lobe, const Vec3f& wo) {
    return std::visit([&](const auto& kind) { return mean(kind.albedo(wo)); }, lobe);
}

}  // namespace

std::size_t Bsdf::Picks::chosen(float choice, std::size_t count) const {
    std::size_t last = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (of[k] == 0) continue;
        last = k;
        choice -= of[k];
        if (choice < 0) break;
    }
    return last;
}

Bsdf::Bsdf(const Vec3& ng, const Vec3& ns, const Vec3& tangent)
    : ng_(ng), ns_(ns), x_(orthonormal_tangent(ns, tangent)), y_(ns_.cross(x_)) {}

Bsdf::Bsdf(const Bsdf& other) : ng_(other.ng_), ns_(other.ns_), x_(other.x_), y_(other.y_) {
    for (const Lobe& lobe : other.lobes()) add(lobe);
}

void Bsdf::scale_lobes(std::size_t first, const Color& by) {
    for (std::size_t k = first; k < count_; ++k) {
        std::visit([&](auto& lobe) { lobe.scale(by); }, lobes_[k]);
    }
    picked_for_ = Vec3f(0);
}

Vec3 Bsdf::to_local(const Vec3& w) const {
    return {w.dot(x_), w.dot(y_), w.dot(ns_)};
}

Vec3 Bsdf::to_world(const Vec3& w) const {
    const Vec3 sum = w.x * x_ + w.y * y_ + w.z * ns_;
    // A step of Newton's method towards unit length, off by the roundings of floats.
    return sum * (1.5 - 0.5 * sum.dot(sum));
}

const Bsdf::Picks& Bsdf::picks(const Vec3f& wo) const {
    static constexpr Picks the_only_one{{1}};
    if (count_ == 1) return the_only_one;
    if (wo == picked_for_) return picks_;
    picked_for_ = wo;
    float total = 0;
    for (std::size_t k = 0; k < count_; ++k) total += picks_.of[k] = albedo_of(lobes_[k], wo);
    const float scale = total > 0 ? 1 / total : 0;
    for (std::size_t k = 0; k < count_; ++k) picks_.of[k] *= scale;
    return picks_;
}

Evaluation Bsdf::evaluate_local(const Picks& picks, const Vec3f& wo, const Vec3f& wi,
                                LobeKind side) const {
    Evaluation sum;
    for (std::size_t k = 0; k < count_; ++k) {
        std::visit(
            [&](const auto& lobe) {
                if constexpr (!is_specular(lobe.kind)) {
                    const Evaluation part = lobe.evaluate(wo, wi);
                    if (lobe.kind == side) sum.f += part.f;
                    if (!is_diffuse<std::decay_t<decltype(lobe)>> || lobe.kind == side) {
                        sum.pdf += picks.of[k] * part.pdf;
                    }
                }
            },
            lobes_[k]);
    }
    return sum;
}

LobeKind Bsdf::side(const Vec3& wo, const Vec3& wi) const {
    return wi.dot(ng_) * wo.dot(ng_) > 0 ? LobeKind::reflection : LobeKind::transmission;
}

Evaluation Bsdf::evaluate(const Vec3& wo, const Vec3& wi) const {
    const Vec3f local_wo(to_local(wo));
    if (local_wo.z == 0 || count_ == 0) return {};
    return evaluate_local(picks(local_wo), local_wo, Vec3f(to_local(wi)), side(wo, wi));
}

std::optional<BsdfSample> Bsdf::sample_smooth(const Picks& picks, const Vec3& wo,
                                              const Vec3f& local_wo, Vec3f local_wi,
                                              std::optional<LobeKind> diffuse_side) const {
    Vec3 wi = to_world(Vec3(local_wi));
    LobeKind where = side(wo, wi);
    const bool turned = diffuse_side && where != *diffuse_side;
    if (turned) {
        wi = -wi;
        local_wi = -local_wi;
        where = side(wo, wi);
    }
    const Evaluation e = evaluate_local(picks, local_wo, local_wi, where);
    if (!(e.pdf > 0) || is_black(e.f)) return {};
    const bool transmission = where == LobeKind::transmission;
    return BsdfSample{wi, e.f, e.pdf, false, transmission, turned, 1};
}

std::optional<BsdfSample> Bsdf::sample_specular(float pick,
                                                const std::optional<SpecularSample>& chosen) const {
    if (!chosen || chosen->wi.z == 0) return {};
    const auto cos = static_cast<float>(std::abs(chosen->wi.z));
    return BsdfSample{to_world(chosen->wi),
                      chosen->weight / cos,
                      pick * chosen->probability,
                      true,
                      chosen->transmission,
                      false,
                      chosen->eta};
}

std::optional<BsdfSample> Bsdf::sample(const Vec3& wo, float lobe_choice, const Vec2& uv) const {
    const Vec3 exact_wo = to_local(wo);
    const Vec3f local_wo(exact_wo);
    if (local_wo.z == 0 || count_ == 0) return {};
    const Picks& picks = this->picks(local_wo);
    const std::size_t chosen = picks.chosen(lobe_choice, count_);
    return std::visit(
        [&](const auto& lobe) -> std::optional<BsdfSample> {
            if constexpr (is_specular(lobe.kind)) {
                return sample_specular(picks.of[chosen], lobe.sample(exact_wo, uv.x));
            } else {
                const std::optional<Vec3f> local_wi = lobe.sample(local_wo, uv);
                if (!local_wi) return {};
                std::optional<LobeKind> diffuse_side;
                if (is_diffuse<std::decay_t<decltype(lobe)>>) diffuse_side = lobe.kind;
                auto sampled = sample_smooth(picks, wo, local_wo, *local_wi, diffuse_side);
                if (sampled) sampled->eta = index_beyond(lobe, local_wo);
                return sampled;
            }
        },
        lobes_[chosen]);
}

bool Bsdf::is_smooth() const {
    return std::any_of(lobes().begin(), lobes().end(), [](const Lobe& lobe) {
        return std::visit([](const auto& kind) { return !is_specular(kind.kind); }, lobe);
    });
}

Color Bsdf::albedo(const Vec3& wo) const {
    const Vec3f local_wo(to_local(wo));
    Color sum(0);
    for (const Lobe& lobe : lobes()) {
        sum += std::visit([&](const auto& kind) { return kind.albedo(local_wo); }, lobe);
    }
    return sum;
}

}  // namespace etalon
