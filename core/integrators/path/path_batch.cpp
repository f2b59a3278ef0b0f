#include "core/integrators/path/path_batch.h"

#include <algorithm>

#include "core/integrators/path/ray_segments.h"
#include "core/sampling/dimensions.h"
#include "core/shading/shadow_rays.h"

namespace etalon {
namespace {

/// Weight of a direction chosen with density `a` that another strategy would have chosen with `b`
/// (power heuristic: Veach 1997, section 9.2).
float power_weight(float a, float b) {
    return a * a / (a * a + b * b);
}

/// The same for lights whose density is compensated (balance heuristic: Karlik et al. 2019).
float balance_weight(float a, float b) {
    return a / (a + b);
}

/// Density with which a vertex chooses a direction that its scattering chooses with `own`.
template <bool in_media, class Vertex>
float density_of(const Vertex& at, const Vec3& wi, float own) {
    if (!in_media || !at.lit_regions) return own;
    const float part = at.lit_regions->part();
    return (1 - part) * own + (at.reflects(wi) ? part * at.lit_regions->density(wi) : 0);
}

/// Chooses a direction in which a path goes on: by the scattering, and partly by where lit regions
/// are. `favour` is set to its density over the one with which scattering alone chooses it, if that
/// is another.
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

template <bool in_media>
PathBatch<in_media>::PathBatch(const PathScene& scene, const CameraSamples& samples,
                               std::span<Color> colors, RayCounts& counts, int most_vertices)
    : shared_(scene),
      samples_(samples),
      colors_(colors),
      counts_(counts),
      most_vertices_(most_vertices) {
    rays_.reserve(samples.rays.size());
    for (std::size_t i = 0; i < samples.rays.size(); ++i) rays_.push_back(samples.rays[i]);
    paths_.reserve(rays_.size());
    for (std::uint32_t i = 0; i < rays_.size(); ++i) {
        paths_.push_back({i, camera_ray_name, samples.sources[i]});
    }
    if constexpr (in_media) media_.assign(rays_.size(), scene.scene.physical().camera_medium);
    counts_.camera += rays_.size();
}

template <bool in_media>
void PathBatch<in_media>::run() {
    std::ranges::fill(colors_, Color(0.0F));
    for (bool from_camera = true; !paths_.empty(); from_camera = false) {
        hits_.resize(rays_.size());
        shared_.intersector.closest(rays_, hits_);
        shadow_rays_.clear();
        answers_.clear();
        if constexpr (in_media) {
            shadow_media_.clear();
            fly_all();
        }
        make_points();
        shade_all(from_camera);
        if (!entries_.empty()) scatter_below();
        add_answers();
        std::swap(rays_, next_rays_);
        std::swap(paths_, next_paths_);
        if constexpr (in_media) std::swap(media_, next_media_);
    }
}

template <bool in_media>
void PathBatch<in_media>::make_points() {
    clear_points();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (may_scatter(i)) add_points(paths_[i]);
    }
    make_added_points();
}

template <bool in_media>
void PathBatch<in_media>::clear_points() {
    asked_.clear();
    ways_.clear();
    light_points_.clear();
}

/// Adds the choices of a path's next vertex to those that are made together.
template <bool in_media>
void PathBatch<in_media>::add_points(const Path& path) {
    const std::uint32_t ways = ways_of(path);
    for (std::uint32_t way = 0; way < ways; ++way) {
        path.source.part(way, ways).add_vertex(path.name, ways_);
    }
    if (shared_.asks_all) {
        add_light_points(path);
    } else {
        path.source.add_vertex(path.name, asked_);
    }
}

template <bool in_media>
void PathBatch<in_media>::make_added_points() {
    asked_.make(shared_.sampler);
    ways_.make(shared_.sampler);
    on_lights_ = light_points_.make();
}

template <bool in_media>
void PathBatch<in_media>::add_light_points(const Path& path) {
    for (std::uint32_t light = 0; light < shared_.lights.size(); ++light) {
        const auto samples = static_cast<std::uint32_t>(shared_.lights.samples(light));
        const std::uint32_t dimension = light_dimension(path.name, light);
        for (std::uint32_t k = 0; k < samples; ++k) {
            path.source.add_stratified(dimension, k, samples, light_points_);
        }
    }
}

template <bool in_media>
void PathBatch<in_media>::shade_all(bool from_camera) {
    next_rays_.clear();
    next_paths_.clear();
    if constexpr (in_media) next_media_.clear();
    VertexNumbers numbers;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if (is_in_medium(i)) {
            scatter_in_medium(i, numbers);
        } else if (hits_[i].primitive == no_index) {
            add_escaped(paths_[i], rays_[i].direction);
        } else {
            ++(from_camera ? counts_.camera_hits : counts_.secondary_hits);
            shade(i, numbers);
        }
        if (!may_scatter(i)) continue;
        ++numbers.vertex;
        numbers.first_way += ways_of(paths_[i]);
    }
}

template <bool in_media>
void PathBatch<in_media>::shade(std::size_t ray, const VertexNumbers& numbers) {
    Path& path = paths_[ray];
    const Vec3& direction = rays_[ray].direction;
    const PhysicalSurface surface = physical_surface(shared_.scene, rays_[ray], hits_[ray]);
    add_emitted(path, surface, direction);
    if (shared_.shading.is_passed(surface)) {
        next_rays_.push_back(ray_beyond(rays_[ray], hits_[ray], surface.point.convexity));
        next_paths_.push_back(path);
        if constexpr (in_media) {
            next_paths_.back().name = ray_name(path.name, true);
            next_media_.push_back(medium_beyond(surface, direction, media_[ray]));
        }
        ++counts_.refracted;
        return;
    }
    if (!may_scatter(ray)) return;
    std::optional<LobeList> room;
    std::optional<Subsurface> room_below;
    const auto [frame, lobes] = shared_.shading.scattering(surface, room);
    SurfaceVertex at{
        {numbers, lobes.has_smooth() ? ways_of(path) : 1},
        surface,
        frame,
        BsdfFrom(frame, lobes, -normalized(direction)),
        in_media ? media_[ray] : no_index,
        shared_.direct_only ? nullptr : shared_.shading.subsurface(surface, room_below)};
    const bool is_above = surface.ng.dot(direction) < 0;
    path.last.position = surface.point.position;
    path.last.normal = lobes.has_smooth_transmission() ? Vec3(0)
                       : is_above                      ? surface.ng
                                                       : -surface.ng;
    if (lobes.has_smooth() && !lobes.has_smooth_transmission()) see_lit_regions(path.last, at);
    if (lobes.has_smooth() && !shared_.lights.empty()) ask_lights(path, at);
    scatter(path, at);
}

/// Lets a vertex choose directions by the lit regions, if it sees any.
template <bool in_media>
void PathBatch<in_media>::see_lit_regions(const Receiver& at, PathVertex& vertex) {
    if constexpr (in_media) {
        if (!shared_.lit_regions) return;
        lit_regions_.emplace(*shared_.lit_regions, at);
        if (!lit_regions_->empty()) vertex.lit_regions = &*lit_regions_;
    }
}

/// Scatters a path in the medium that its ray goes through.
template <bool in_media>
void PathBatch<in_media>::scatter_in_medium(std::size_t ray, const VertexNumbers& numbers) {
    Path& path = paths_[ray];
    const Vec3 direction = normalized(rays_[ray].direction);
    path.last.position = rays_[ray].origin + flights_[ray] * rays_[ray].direction;
    path.last.normal = Vec3(0);
    MediumVertex at{{numbers, ways_of(path)},
                    path.last.position,
                    direction,
                    shared_.media.phase(media_[ray]),
                    media_[ray],
                    rays_[ray].time(),
                    segment_of(rays_[ray], end_of(hits_[ray])),
                    flight_densities_[ray]};
    see_lit_regions(path.last, at);
    if (!shared_.lights.empty()) ask_lights(path, at);
    scatter(path, at);
}

template <bool in_media>
void PathBatch<in_media>::add_escaped(const Path& path, const Vec3& direction) {
    for (const std::uint32_t light : shared_.lights.infinite()) {
        const InfiniteLight& infinite = shared_.lights.infinite_light(light);
        const Color radiance = infinite.radiance(direction);
        float weight = 1;
        if (!path.specular && infinite.can_be_sampled()) {
            const double asked =
                shared_.expected_samples(path.last, light) * infinite.pdf(direction);
            weight = balance_weight(path.density, static_cast<float>(asked));
        }
        add(path, weight * radiance);
    }
}

template <bool in_media>
void PathBatch<in_media>::add_emitted(const Path& path, const PhysicalSurface& at,
                                      const Vec3& direction) {
    const SurfaceBinding& binding = *at.binding;
    if (binding.light == no_index) return;
    const std::uint32_t light =
        shared_.lights.number_of(binding.light + (at.point.primitive - binding.first));
    const Color radiance = shared_.lights.emitted(light, at.point, direction);
    if (radiance == Color(0.0F)) return;
    float weight = 1;
    if (!path.specular) {
        const double asked = shared_.expected_samples(path.last, light) *
                             shared_.lights.pdf(light, path.last.position, at.point);
        weight = power_weight(path.density, static_cast<float>(asked));
    }
    add(path, weight * radiance);
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::ask_lights(Path& path, const Vertex& at) {
    if (!shared_.asks_all) {
        const std::size_t number = at.numbers.vertex;
        const auto pick = shared_.lights.pick(path.last, asked_.choices(number).x);
        if (!pick) return;
        ask_light(path, at,
                  {pick->light, static_cast<float>(pick->probability), asked_.place(number), 0});
        return;
    }
    std::size_t first = at.numbers.vertex * shared_.lights.samples(), next = first;
    for (std::uint32_t light = 0; light < shared_.lights.size(); ++light) {
        const int samples = shared_.lights.samples(light);
        for (int k = 0; k < samples; ++k) {
            ask_light(path, at,
                      {light, static_cast<float>(samples), on_lights_[next], next - first});
            ++next;
        }
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::ask_light(const Path& path, const Vertex& at, const Question& question) {
    const LightSample light =
        shared_.lights.sample(question.light, path.last.position, question.uv);
    if (!(light.pdf > 0) || light.radiance == Color(0.0F)) return;
    const Evaluation scattered = at.evaluate(light.wi);
    if (scattered.f == Color(0.0F)) return;

    const float asked = question.expected_samples * light.pdf;
    float weight = 1;
    if (!light.is_delta) {
        const float scattered_density =
            static_cast<float>(at.ways) * density_of<in_media>(at, light.wi, scattered.pdf);
        weight = light.at_infinity ? balance_weight(asked, scattered_density)
                                   : power_weight(asked, scattered_density);
    }
    if constexpr (std::is_same_v<Vertex, MediumVertex>) {
        if (light.is_delta && !light.at_infinity) weight = flight_share(at, question);
    }
    const float cosine = at.cosine(light.wi);
    const Color color = scattered.f * light.radiance * (cosine * weight / asked);
    Ray ray = light.at_infinity ? at.ray(light.wi) : at.ray_to(light.target);
    if (!light.at_infinity) ray.tmax = shadow_end;
    if constexpr (in_media) {
        if (light.at_infinity && light.is_delta) ray.tmax = 2 * shared_.lights.scene_radius();
        shadow_media_.push_back(
            {at.medium_towards(light.wi),
             path.source.sequence(shadow_collision_dimension(path.name, question.number))});
    }
    ray.set_shadow();
    shadow_rays_.push_back(ray);
    answers_.push_back({path.sample, path.throughput * color});
}

template <bool in_media>
void PathBatch<in_media>::add_answers() {
    blocked_.resize(shadow_rays_.size());
    counts_.shadow += shadow_rays_.size();
    if constexpr (in_media) {
        attenuate_answers();
    } else {
        shared_.intersector.occluded(shadow_rays_, blocked_);
    }
    for (std::size_t i = 0; i < answers_.size(); ++i) {
        counts_.shadow_blocked += blocked_[i];
        if (blocked_[i] == 0) colors_[answers_[i].sample] += answers_[i].color;
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::scatter(const Path& path, const Vertex& at) {
    if (at.ways == 1) return scatter(path, at, at.numbers.first_way);
    Path part = path;
    part.is_split = true;
    part.throughput /= static_cast<float>(at.ways);
    for (std::uint32_t i = 0; i < at.ways; ++i) {
        part.source = path.source.part(i, at.ways);
        scatter(part, at, at.numbers.first_way + i);
    }
}

template <bool in_media>
template <class Vertex>
void PathBatch<in_media>::scatter(const Path& path, const Vertex& at, std::size_t way) {
    const Vec2 choices = ways_.choices(way);
    float favour = 1;
    const std::optional<BsdfSample> s =
        sample_direction<in_media>(at, choices.x, ways_.place(way), favour);
    if (!s || s->f == Color(0.0F) || !(s->pdf > 0)) return;
    if constexpr (std::is_same_v<Vertex, SurfaceVertex>) {
        if (at.subsurface && s->transmission) return enter(path, at, *s);
    }
    const float cosine = at.cosine(s->wi);
    Path& next = next_paths_.emplace_back(path);
    next.throughput *= s->f * (cosine / s->pdf);
    next.density = static_cast<float>(at.ways) * s->pdf;
    next.specular = s->specular;
    // From between the horizons pbrt-v3 takes the light of lights only.
    next.last_ray = s->turned || (shared_.direct_only && !s->specular);
    next.eta_scale *= s->eta * s->eta * favour;
    ++next.depth;
    next.name = ray_name(path.name, false);
    if (!survives(next, choices.y)) {
        next_paths_.pop_back();
        return;
    }
    next_rays_.push_back(at.ray(s->wi));
    if constexpr (in_media) next_media_.push_back(at.medium_towards(s->wi));
    ++(s->transmission ? counts_.refracted : counts_.reflected);
}

/// Russian roulette by throughput: a path goes on with a probability in proportion to what it may
/// still carry, so that those that do carry about the same.
template <bool in_media>
bool PathBatch<in_media>::survives(Path& path, double choice) const {
    // Both by measurement: earlier, or by less of the throughput as in pbrt-v3, costs more by the
    // noise of the survivors than it saves in rays.
    constexpr int first_at_stake = 3;
    constexpr float part_kept = 2.5F;
    if (path.depth < first_at_stake) return true;
    const float parts = path.is_split ? static_cast<float>(split_ways) : 1.0F;
    const Color expected = path.throughput * (path.eta_scale * parts);
    const float most = std::max({expected.x, expected.y, expected.z});
    const float survival = part_kept * most / shared_.roulette_threshold;
    if (!(survival < 1)) return true;
    if (choice >= survival) return false;
    path.throughput /= survival;
    return true;
}

template class PathBatch<false>;
template class PathBatch<true>;
template void PathBatch<false>::ask_lights(Path&, const SurfaceVertex&);
template void PathBatch<true>::ask_lights(Path&, const SurfaceVertex&);
template void PathBatch<false>::scatter(const Path&, const SurfaceVertex&);
template void PathBatch<true>::scatter(const Path&, const SurfaceVertex&);

}  // namespace etalon
