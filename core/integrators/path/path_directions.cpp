// Directions in which paths continue from their vertices.
#include <algorithm>

#include "core/integrators/path/path_batch.h"
#include "core/integrators/path/path_directions.h"
#include "core/sampling/dimensions.h"

namespace etalon {
namespace {

/// Samples the direction in which a path continues: by its scattering, and partly towards lit
/// regions. Sets `favour` to its density over that of scattering alone, if they differ.
template <bool in_media, class Vertex>
std::optional<BsdfSample> sample_direction(const Vertex& at, double choice, const Vec2& uv,
                                           float& favour) {
    if (!in_media || !at.lit_regions) return at.sample(static_cast<float>(choice), uv);
    const float part = at.lit_regions->part();
    std::optional<BsdfSample> s;
    if (choice < part) {
        const Vec3 wi = at.lit_regions->sample(choice / part, uv);
        if (!at.reflects(wi)) return std::nullopt;
        const Evaluation e = at.evaluate(wi);
        s = {wi, e.f, e.pdf, false, false, false, 1};
    } else {
        s = at.sample(static_cast<float>((choice - part) / (1 - part)), uv);
    }
    if (!s || !(s->pdf > 0)) return std::nullopt;
    const float own = s->pdf;
    s->pdf = s->specular ? (1 - part) * own : density_of<in_media>(at, s->wi, own);
    favour = s->pdf / own;
    return s;
}

}  // namespace

/// Lets a vertex sample directions to the lit regions, if it sees any.
template <bool in_media>
void PathBatch<in_media>::see_lit_regions(const Receiver& at, PathVertex& vertex) {
    if constexpr (in_media) {
        if (!shared_.lit_regions) return;
        lit_regions_.emplace(*shared_.lit_regions, at);
        if (!lit_regions_->empty()) vertex.lit_regions = &*lit_regions_;
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::scatter(const PathState& path, const Vertex& at) {
    if (at.split_count == 1) return scatter(path, at, at.numbers.first_split);
    PathState part = path;
    part.is_split = true;
    part.throughput /= static_cast<float>(at.split_count);
    part.roulette_scale *= static_cast<float>(at.split_count);
    for (std::uint32_t i = 0; i < at.split_count; ++i) {
        part.source = path.source.part(i, at.split_count);
        scatter(part, at, at.numbers.first_split + i);
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::scatter(const PathState& path, const Vertex& at, std::size_t split) {
    const Vec2 choices = points_.direction_choices(split);
    if (choices.y >= at.survival) return;
    float favour = 1;
    const std::optional<BsdfSample> s =
        sample_direction<in_media>(at, choices.x, points_.direction(split), favour);
    if (!s || s->f == Color(0.0F) || !(s->pdf > 0)) return;
    if constexpr (std::is_same_v<Vertex, SurfaceVertex>) {
        if (at.subsurface && s->transmission) return below_.add(path, at, *s);
    }
    // Direct lighting ends with a lit vertex, not with a ray from it to a light in a mirror.
    if (shared_.direct_only && s->specular && path.depth + 1 >= shared_.most_vertices) return;
    const float cosine = at.cosine(s->wi);
    PathState& next = next_.paths.emplace_back(path);
    next.throughput *= s->f * (cosine / (s->pdf * at.survival));
    next.density = at.expected_paths() * s->pdf;
    next.specular = s->specular;
    next.is_unlit = false;
    next.last_ray = s->only_lights || (shared_.direct_only && !s->specular);
    next.roulette_scale *= s->eta * s->eta * favour;
    ++next.depth;
    next.name = ray_name(path.name, false);
    if (std::is_same_v<Vertex, SurfaceVertex> && !survives(next, choices.y)) {
        next_.paths.pop_back();
        return;
    }
    next_.rays.push_back(at.ray(s->wi));
    if constexpr (in_media) next_.media.push_back(at.medium_towards(s->wi));
    ++(s->transmission ? counts_.refracted : counts_.reflected);
}

/// Returns the probability with which a path continues, in proportion to its throughput, so that
/// those that do have about the same (Russian roulette).
template <bool in_media>
float PathBatch<in_media>::survival(const PathState& path) const {
    constexpr float part_kept = 2.5F;  // by measurement: below, the survivors' noise costs more
    const Color expected = path.throughput * path.roulette_scale;
    const float most = std::max({expected.x, expected.y, expected.z});
    return std::min(part_kept * most / shared_.roulette_threshold, 1.0F);
}

/// Returns whether a path from a surface continues; it then gets the weight of those that end.
template <bool in_media>
bool PathBatch<in_media>::survives(PathState& path, double choice) const {
    constexpr int first_at_stake = 3;  // by measurement, too
    if (path.depth < first_at_stake) return true;
    const float probability = survival(path);
    if (choice >= probability) return false;
    path.throughput /= probability;
    return true;
}

template void PathBatch<false>::see_lit_regions(const Receiver&, PathVertex&);
template void PathBatch<true>::see_lit_regions(const Receiver&, PathVertex&);
template float PathBatch<false>::survival(const PathState&) const;
template float PathBatch<true>::survival(const PathState&) const;
template void PathBatch<false>::scatter(const PathState&, const SurfaceVertex&);
template void PathBatch<true>::scatter(const PathState&, const SurfaceVertex&);
template void PathBatch<true>::scatter(const PathState&, const MediumVertex&);
template void PathBatch<false>::scatter(const PathState&, const MediumVertex&);

}  // namespace etalon
