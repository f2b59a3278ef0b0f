#include <memory>

#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"

namespace etalon::hard {
namespace {

Extent middle_of(const Box3& box) {
    return {box.center(), max_abs(box.size()) / 2};
}

constexpr std::uint64_t moving_seed = 43;
constexpr int moments = 50;  ///< times at which moving items are aimed at

/// Targets and extents of a scene, from which rays are generated.
class RayContext {
  public:
    RayContext(Scene scene, double finest) : scene_(std::make_shared<Scene>(std::move(scene))) {
        std::vector<Box3> boxes;
        Box3 all;
        const auto add = [&](const Box3& box) {
            if (!box.isEmpty() && is_finite(box.size())) all.extendBy(box);
            boxes.push_back(box);
        };
        for (std::uint32_t id = 0; id < scene_->geometry.primitives.size(); ++id) {
            add(primitive_bounds(scene_->geometry, id));
        }
        for (const Box3& box : instance_bounds(scene_->geometry, all).boxes) add(box);
        if (!all.isEmpty()) whole_ = middle_of(all);
        for (std::uint32_t id = 0; id < scene_->geometry.item_count(); ++id) {
            if (boxes[id].isEmpty()) continue;
            const bool bounded = is_finite(boxes[id].size());
            add_item(id, bounded ? middle_of(boxes[id]) : whole_, finest);
        }
    }

    const Scene& scene() const { return *scene_; }
    const Extent& whole() const { return whole_; }

    /// Position and targets of one primitive or instance at one time.
    struct AimedItem {
        Extent extent;
        ShutterTime time;
        std::vector<Target> targets;
    };
    const AimedItem& any(Random& random) const { return items_[random.index(items_.size())]; }

  private:
    /// Adds an item; a moving one is added at several times.
    void add_item(std::uint32_t item, const Extent& extent, double finest) {
        const Geometry& g = scene_->geometry;
        const bool moves = g.is_instance(item) && g.instances[g.instance_number(item)].moves();
        Random random(moving_seed, item);
        for (int i = 0; i < (moves ? moments : 1); ++i) {
            const ShutterTime time = i == 0 ? 0 : shutter_time(random.uniform());
            items_.push_back({extent, time, targets_of(g, item, finest, time)});
        }
    }

    std::shared_ptr<const Scene> scene_;
    Extent whole_{Vec3(0), 1};  ///< bounds of the bounded items
    std::vector<AimedItem> items_;
};

const Target& any_target(const RayContext::AimedItem& item, Random& random) {
    return item.targets[random.index(item.targets.size())];
}

/// Sets tmin or tmax near the point of the ray that is closest to the target.
void limit(Ray& ray, const Vec3& point, Random& random) {
    const double length2 = ray.direction.dot(ray.direction);
    const double t = std::abs((point - ray.origin).dot(ray.direction)) / length2;
    if (!std::isfinite(t)) return;
    ray.tmin = t * random.uniform();
    if (random.index(2) == 0) ray.tmax = ray.tmin + t * random.uniform(0, 2);
}

/// Returns a case setup whose ray generator uses the scene.
CaseSetup case_setup(Scene scene, double finest, Ray (*make)(const RayContext&, Random&)) {
    const auto context = std::make_shared<const RayContext>(std::move(scene), finest);
    return {context->scene(), context->whole().size,
            [=](Random& random) { return make(*context, random); }};
}

Ray aimed_ray(const RayContext& context, Random& random) {
    const RayContext::AimedItem& item = context.any(random);
    const Extent& seen_from = random.index(2) == 0 ? item.extent : context.whole();
    Ray ray = ray_generator(seen_from, any_target(item, random), random);
    ray.set_time(item.time);
    if (random.index(3) == 0) limit(ray, item.extent.centre, random);
    return ray;
}

Ray bouncing_ray(const RayContext& context, Random& random) {
    const RayContext::AimedItem& item = context.any(random);
    const Vec3 eye = context.whole().centre + context.whole().size * random.in_cube();
    const Vec3 surface = any_target(item, random)(eye, random);
    const Vec3 direction = random.direction();
    return {surface + item.extent.size * random.magnitude(-6, -1) * direction, direction};
}

}  // namespace

CaseSetup aimed_at_scene(Scene scene, double finest) {
    return case_setup(std::move(scene), finest, aimed_ray);
}

CaseSetup bouncing_in_scene(Scene scene) {
    return case_setup(std::move(scene), -6, bouncing_ray);
}

CaseSetup camera_rays_of(Scene scene, double distance) {
    const Extent whole = RayContext(scene, -6).whole();
    const Vec3 ahead = tilted(0, 0, 1);
    return {std::move(scene), whole.size, [=](Random& random) {
                const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
                return Ray{whole.centre - distance * whole.size * ahead,
                           distance * ahead + tilted(x, y, 0)};
            }};
}

}  // namespace etalon::hard
