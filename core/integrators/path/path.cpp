#include "core/integrators/path/path.h"

#include <algorithm>

#include "core/sampling/dimensions.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

/// A path on its way: what its camera ray will see, and what the last vertex must know to weigh
/// the light that the next one finds.
struct PathTracer::Path {
    std::size_t sample;  ///< number in the batch
    std::uint32_t name;  ///< of its ray, for sample dimensions
    Color throughput{1.0F};
    Receiver last{};        ///< the vertex the ray left
    float pdf = 0;          ///< density of the ray's direction there
    bool specular = true;   ///< no light could have been asked for that direction
    float eta_scale = 1;    ///< square of the index that throughput has been divided by
    int depth = 0;          ///< number of vertices that scattered
    bool last_ray = false;  ///< only what shines at its end counts
};

/// A vertex that scatters, with what is known of it.
struct PathTracer::Vertex {
    std::size_t path;
    PhysicalSurface surface;
    Vec3 wo;
    Bsdf bsdf;
};

/// The paths of one call.
class PathTracer::Batch {
  public:
    Batch(const PathTracer& tracer, const CameraSamples& samples, std::span<Color> colors,
          RayCounts& counts)
        : t_(tracer), samples_(samples), colors_(colors), counts_(counts) {
        rays_.assign(samples.rays.begin(), samples.rays.end());
        paths_.reserve(rays_.size());
        for (std::size_t i = 0; i < rays_.size(); ++i) paths_.push_back({i, camera_ray_name});
        counts_.camera += rays_.size();
    }

    void run() {
        std::ranges::fill(colors_, Color(0.0F));
        for (bool from_camera = true; !paths_.empty(); from_camera = false) {
            hits_.resize(rays_.size());
            t_.intersector_.closest(rays_, hits_);
            find_vertices(from_camera);
            make_points();
            ask_lights();
            go_on();
        }
    }

  private:
    /// A direction to a light that a vertex asks for.
    struct Question {
        std::size_t vertex;
        std::uint32_t light;
        float expected_samples;  ///< see PathTracer::expected_samples
    };

    /// What a light gives if nothing is in the way.
    struct Answer {
        std::size_t sample;
        Color color;
    };

    /// Adds what shines at the end of each ray. Collects the vertices that scatter.
    void find_vertices(bool from_camera);
    void add_escaped(const Path& path, const Vec3& direction);
    void add_emitted(const Path& path, const PhysicalSurface& at, const Vec3& direction);
    void add_vertex(std::size_t path, const PhysicalSurface& at);

    /// Makes the sample points of all vertices together.
    void make_points();

    void ask_lights();
    void choose_lights(const Vertex& v, std::size_t number);
    void ask_light(const Question& q, const Vec2& uv);
    void pass_cut_outs();

    /// Replaces rays and paths by those that go on.
    void go_on();
    void scatter(const Vertex& v, std::size_t number);
    bool survives(Path& path) const;

    void add(const Path& path, const Color& color) {
        colors_[path.sample] += path.throughput * color;
    }

    const PathTracer& t_;
    const CameraSamples& samples_;
    std::span<Color> colors_;
    RayCounts& counts_;

    std::vector<Ray> rays_, next_rays_;
    std::vector<Path> paths_, next_paths_;
    std::vector<Hit> hits_;
    std::vector<Vertex> vertices_;
    PointBatch light_and_lobe_, light_points_, directions_;
    std::span<const Vec2> choices_, in_lobes_;

    std::vector<Question> questions_;
    std::vector<Ray> shadow_rays_;
    std::vector<Answer> answers_;
    std::vector<std::uint8_t> blocked_;
};

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

}  // namespace

void PathTracer::Batch::add_escaped(const Path& path, const Vec3& direction) {
    for (const std::uint32_t light : t_.lights_.infinite()) {
        const InfiniteLight& infinite = t_.lights_.infinite_light(light);
        const Color radiance = infinite.radiance(direction);
        float weight = 1;
        if (!path.specular && infinite.can_be_sampled()) {
            const double asked = t_.expected_samples(path.last, light) * infinite.pdf(direction);
            weight = balance_weight(path.pdf, static_cast<float>(asked));
        }
        add(path, weight * radiance);
    }
}

void PathTracer::Batch::add_emitted(const Path& path, const PhysicalSurface& at,
                                    const Vec3& direction) {
    const SurfaceBinding& binding = *at.binding;
    if (binding.light == no_index) return;
    const std::uint32_t light =
        t_.lights_.number_of(binding.light + (at.point.primitive - binding.first));
    const Color radiance = t_.lights_.emitted(light, at.point, direction);
    if (radiance == Color(0.0F)) return;
    float weight = 1;
    if (!path.specular) {
        const double asked = t_.expected_samples(path.last, light) *
                             t_.lights_.pdf(light, path.last.position, at.point);
        weight = power_weight(path.pdf, static_cast<float>(asked));
    }
    add(path, weight * radiance);
}

void PathTracer::Batch::add_vertex(std::size_t path, const PhysicalSurface& at) {
    const Vec3 wo = -normalized(rays_[path].direction);
    vertices_.push_back({path, at, wo, t_.shading_.scattering(at)});
}

void PathTracer::Batch::find_vertices(bool from_camera) {
    vertices_.clear();
    next_rays_.clear();
    next_paths_.clear();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const Path& path = paths_[i];
        const Vec3& direction = rays_[i].direction;
        if (hits_[i].primitive == no_index) {
            add_escaped(path, direction);
            continue;
        }
        (from_camera ? counts_.camera_hits : counts_.secondary_hits) += 1;
        const PhysicalSurface at = physical_surface(t_.scene_, rays_[i], hits_[i]);
        const bool cut_out = t_.shading_.is_cut_out(at, PhysicalShading::RayKind::seeing);
        if (!cut_out) add_emitted(path, at, direction);
        if (cut_out || t_.shading_.is_passed(at)) {
            next_rays_.push_back(spawn_ray(at.point, direction));
            next_paths_.push_back(path);
            ++counts_.refracted;
            continue;
        }
        if (path.last_ray || path.depth >= t_.most_vertices_) continue;
        add_vertex(i, at);
    }
}

void PathTracer::Batch::make_points() {
    light_and_lobe_.clear();
    directions_.clear();
    for (const Vertex& v : vertices_) {
        const Path& path = paths_[v.path];
        const SampleSource& source = samples_.sources[path.sample];
        const auto add = [&](PathDimension choice, PointBatch& to) {
            source.add_stratified(vertex_dimension(path.name, choice), 0, 1, to);
        };
        add(light_and_lobe, light_and_lobe_);
        add(scattered_direction, directions_);
    }
    choices_ = light_and_lobe_.make();
    in_lobes_ = directions_.make();
}

void PathTracer::Batch::choose_lights(const Vertex& v, std::size_t number) {
    Path& path = paths_[v.path];
    path.last.position = v.surface.point.position;
    const SampleSource& source = samples_.sources[path.sample];
    if (!t_.asks_all_) {
        const auto pick = t_.lights_.pick(path.last, choices_[number].x);
        if (!pick) return;
        questions_.push_back({number, pick->light, static_cast<float>(pick->probability)});
        source.add_stratified(vertex_dimension(path.name, light_point), 0, 1, light_points_);
        return;
    }
    for (std::uint32_t light = 0; light < t_.lights_.size(); ++light) {
        const auto samples = static_cast<std::uint32_t>(t_.lights_.samples(light));
        for (std::uint32_t k = 0; k < samples; ++k) {
            questions_.push_back({number, light, static_cast<float>(samples)});
            source.add_stratified(light_dimension(path.name, light), k, samples, light_points_);
        }
    }
}

void PathTracer::Batch::ask_light(const Question& q, const Vec2& uv) {
    const Vertex& v = vertices_[q.vertex];
    const Path& path = paths_[v.path];
    const LightSample light = t_.lights_.sample(q.light, path.last.position, uv);
    if (!(light.pdf > 0)) return;
    const Evaluation scattered = v.bsdf.evaluate(v.wo, light.wi);
    if (scattered.f == Color(0.0F)) return;

    const float asked = q.expected_samples * light.pdf;
    float weight = 1;
    if (!light.is_delta) {
        weight = light.at_infinity ? balance_weight(asked, scattered.pdf)
                                   : power_weight(asked, scattered.pdf);
    }
    const auto cosine = static_cast<float>(std::abs(v.bsdf.ns().dot(light.wi)));
    const Color color = scattered.f * light.radiance * (cosine * weight / asked);
    Ray ray = light.at_infinity ? spawn_ray(v.surface.point, light.wi)
                                : spawn_ray_to(v.surface.point, light.target);
    if (!light.at_infinity) ray.tmax = shadow_end;
    shadow_rays_.push_back(ray);
    answers_.push_back({path.sample, path.throughput * color});
}

/// Asks again for rays that met nothing but holes in surfaces.
void PathTracer::Batch::pass_cut_outs() {
    for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
        Ray ray = shadow_rays_[i];
        const Vec3 target = ray.origin + ray.direction;
        while (blocked_[i] != 0) {
            Hit hit;
            t_.intersector_.closest({&ray, 1}, {&hit, 1});
            blocked_[i] = hit.primitive != no_index ? 1 : 0;
            if (blocked_[i] == 0) break;
            const PhysicalSurface at = physical_surface(t_.scene_, ray, hit);
            if (!t_.shading_.is_cut_out(at, PhysicalShading::RayKind::shadow)) break;
            const double end = ray.tmax;
            ray = end < infinity ? spawn_ray_to(at.point, target)
                                 : spawn_ray(at.point, ray.direction);
            ray.tmax = end;
            ++counts_.shadow;
        }
    }
}

void PathTracer::Batch::ask_lights() {
    questions_.clear();
    light_points_.clear();
    shadow_rays_.clear();
    answers_.clear();
    if (!t_.lights_.empty()) {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            if (vertices_[i].bsdf.is_smooth()) choose_lights(vertices_[i], i);
        }
    }
    const std::span<const Vec2> points = light_points_.make();
    for (std::size_t i = 0; i < questions_.size(); ++i) ask_light(questions_[i], points[i]);
    blocked_.resize(shadow_rays_.size());
    t_.intersector_.occluded(shadow_rays_, blocked_);
    counts_.shadow += shadow_rays_.size();
    if (t_.shading_.has_cut_outs()) pass_cut_outs();
    for (std::size_t i = 0; i < answers_.size(); ++i) {
        counts_.shadow_blocked += blocked_[i];
        if (blocked_[i] == 0) colors_[answers_[i].sample] += answers_[i].color;
    }
}

/// Russian roulette by throughput, as pbrt-v3 plays it.
bool PathTracer::Batch::survives(Path& path) const {
    const Color expected = path.throughput * path.eta_scale;
    const float most = std::max({expected.x, expected.y, expected.z});
    if (!(most < t_.roulette_threshold_) || path.depth <= 4) return true;
    const float end = std::max(0.05F, 1 - most);
    const SampleSource& source = samples_.sources[path.sample];
    if (source.point(vertex_dimension(path.name, survival)).x < end) return false;
    path.throughput /= 1 - end;
    return true;
}

void PathTracer::Batch::scatter(const Vertex& v, std::size_t number) {
    Path path = paths_[v.path];
    const std::optional<BsdfSample> s =
        v.bsdf.sample(v.wo, static_cast<float>(choices_[number].y), in_lobes_[number]);
    if (!s || s->f == Color(0.0F) || !(s->pdf > 0)) return;
    const auto cosine = static_cast<float>(std::abs(v.bsdf.ns().dot(s->wi)));
    path.throughput *= s->f * (cosine / s->pdf);
    path.pdf = s->pdf;
    path.specular = s->specular;
    // From between the horizons pbrt-v3 takes the light of lights only.
    path.last_ray = s->turned || (t_.direct_only_ && !s->specular);
    path.eta_scale *= s->eta * s->eta;
    ++path.depth;
    if (!survives(path)) return;
    path.name = ray_name(path.name, false);
    next_rays_.push_back(spawn_ray(v.surface.point, s->wi));
    next_paths_.push_back(path);
    ++(s->transmission ? counts_.refracted : counts_.reflected);
}

void PathTracer::Batch::go_on() {
    for (std::size_t i = 0; i < vertices_.size(); ++i) scatter(vertices_[i], i);
    std::swap(rays_, next_rays_);
    std::swap(paths_, next_paths_);
}

double PathTracer::expected_samples(const Receiver& at, std::uint32_t light) const {
    return asks_all_ ? lights_.samples(light) : lights_.pick_probability(at, light);
}

PathTracer::PathTracer(const Scene& scene, const BatchIntersector& intersector,
                       const RenderSettings& settings, std::vector<std::string>& problems)
    : scene_(scene),
      intersector_(intersector),
      lights_(scene, problems),
      shading_(scene, problems),
      most_vertices_(settings.max_depth - 1),
      roulette_threshold_(settings.roulette_threshold),
      asks_all_(settings.ask_all_lights),
      direct_only_(settings.direct_lighting) {}

void PathTracer::radiance(const CameraSamples& samples, std::span<Color> colors,
                          RayCounts& counts) const {
    Batch(*this, samples, colors, counts).run();
}

}  // namespace etalon
