#include <memory>

#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"

namespace etalon::hard {
namespace {

Place middle_of(const Box3& box) {
    return {box.center(), max_abs(box.size()) / 2};
}

constexpr std::uint64_t moving_seed = 43;
constexpr int moments = 50;  ///< times at which moving items are aimed at

/// Targets and extents of a scene, from which rays are generated.
class Surroundings {
  public:
    Surroundings(Scene scene, double finest) : scene_(std::make_shared<Scene>(std::move(scene))) {
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
            add_thing(id, bounded ? middle_of(boxes[id]) : whole_, finest);
        }
    }

    const Scene& scene() const { return *scene_; }
    const Place& whole() const { return whole_; }

    /// Position and targets of one primitive or instance at one time.
    struct Thing {
        Place place;
        ShutterTime time;
        std::vector<Target> targets;
    };
    const Thing& any(Random& random) const { return things_[random.index(things_.size())]; }

  private:
    /// Adds an item; a moving one is added at several times.
    void add_thing(std::uint32_t item, const Place& place, double finest) {
        const Geometry& g = scene_->geometry;
        const bool moves = g.is_instance(item) && g.instances[g.instance_number(item)].moves();
        Random random(moving_seed, item);
        for (int i = 0; i < (moves ? moments : 1); ++i) {
            const ShutterTime time = i == 0 ? 0 : shutter_time(random.uniform());
            things_.push_back({place, time, targets_of(g, item, finest, time)});
        }
    }

    std::shared_ptr<const Scene> scene_;
    Place whole_{Vec3(0), 1};  ///< bounds of the bounded items
    std::vector<Thing> things_;
};

const Target& any_target(const Surroundings::Thing& thing, Random& random) {
    return thing.targets[random.index(thing.targets.size())];
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
CaseSetup setting_of(Scene scene, double finest, Ray (*make)(const Surroundings&, Random&)) {
    const auto around = std::make_shared<const Surroundings>(std::move(scene), finest);
    return {around->scene(), around->whole().size,
            [=](Random& random) { return make(*around, random); }};
}

Ray aimed_ray(const Surroundings& around, Random& random) {
    const Surroundings::Thing& thing = around.any(random);
    const Place& seen_from = random.index(2) == 0 ? thing.place : around.whole();
    Ray ray = ray_generator(seen_from, any_target(thing, random), random);
    ray.set_time(thing.time);
    if (random.index(3) == 0) limit(ray, thing.place.centre, random);
    return ray;
}

Ray bouncing_ray(const Surroundings& around, Random& random) {
    const Surroundings::Thing& thing = around.any(random);
    const Vec3 eye = around.whole().centre + around.whole().size * random.in_cube();
    const Vec3 surface = any_target(thing, random)(eye, random);
    const Vec3 direction = random.direction();
    return {surface + thing.place.size * random.magnitude(-6, -1) * direction, direction};
}

}  // namespace

CaseSetup aimed_at_scene(Scene scene, double finest) {
    return setting_of(std::move(scene), finest, aimed_ray);
}

CaseSetup bouncing_in_scene(Scene scene) {
    return setting_of(std::move(scene), -6, bouncing_ray);
}

CaseSetup seen_from_eye(Scene scene, double distance) {
    const Place whole = Surroundings(scene, -6).whole();
    const Vec3 ahead = tilted(0, 0, 1);
    return {std::move(scene), whole.size, [=](Random& random) {
                const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
                return Ray{whole.centre - distance * whole.size * ahead,
                           distance * ahead + tilted(x, y, 0)};
            }};
}

}  // namespace etalon::hard
