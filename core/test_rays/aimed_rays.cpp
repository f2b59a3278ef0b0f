#include "core/test_rays/aimed_rays.h"

#include "core/intersect/kernels.h"
#include "core/test_rays/targets.h"

namespace etalon {
namespace {

constexpr std::uint64_t feature_seed = 7;

/// Silhouettes, rims and tips are missed by 10^-1 down to this power of ten, uniformly in the
/// exponent: some of the rays are too demanding for float, some need all but the last bits of
/// double.
constexpr double finest = -15;

/// Returns the numbers of the existing items of each kind, without degenerate ones.
std::vector<std::vector<std::uint32_t>> items_by_kind(const Geometry& geometry) {
    std::vector<std::vector<std::uint32_t>> kinds(item_kinds);
    for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
        if (!primitive_bounds(geometry, id).isEmpty())
            kinds[geometry.primitives[id].kind].push_back(id);
    }
    for (std::size_t id = geometry.primitives.size(); id < geometry.item_count(); ++id) {
        const Instance& instance = geometry.instances[id - geometry.primitives.size()];
        const bool can_be_hit =
            instance.exists() && !geometry.objects[instance.object].primitives.empty();
        if (can_be_hit) kinds[instance_kind].push_back(static_cast<std::uint32_t>(id));
    }
    std::erase_if(kinds, [](const auto& ids) { return ids.empty(); });
    return kinds;
}

Vec3 anywhere_in(const Box3& box, Random& random) {
    return box.center() + 0.5 * box.size() * random.in_cube();
}

/// Returns what a point of the camera's image shows, to find borders in it.
class ImagePlane {
  public:
    ImagePlane(const Intersector& exact, const CameraRays& camera)
        : exact_(exact), camera_(camera) {}

    Ray through(const Vec2& pixel) const { return camera_.ray(pixel, Vec2(0.5)); }

    HitKey at(const Vec2& pixel) const {
        const std::optional<Hit> hit = exact_.closest(through(pixel));
        return hit ? key_of(hit->primitive, hit->instance) : key_of(no_index, no_index);
    }

    /// Bisects between `a` and `b` until there is no point in between; `a` keeps its visible
    /// primitive, `b` shows another.
    void approach_edge(Vec2& a, Vec2& b) const {
        const HitKey at_a = at(a);
        for (Vec2 middle = (a + b) / 2; middle != a && middle != b; middle = (a + b) / 2) {
            (at(middle) == at_a ? a : b) = middle;
        }
    }

  private:
    const Intersector& exact_;
    const CameraRays& camera_;
};

}  // namespace

std::vector<Ray> rays_at_features(const Scene& scene, const Box3& bounds, std::size_t count) {
    const auto kinds = items_by_kind(scene.geometry);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count && !kinds.empty(); ++i) {
        Random random(feature_seed, i);
        const auto& ids = kinds[random.index(kinds.size())];
        const std::uint32_t item = ids[random.index(ids.size())];
        const ShutterTime time = scene.camera.sees_motion ? shutter_time(random.uniform(0, 1)) : 0;
        const auto targets = targets_of(scene.geometry, item, finest, time);
        const Vec3 origin = i % 2 == 0 ? scene.camera.eye : anywhere_in(bounds, random);
        const Vec3 target = targets[random.index(targets.size())](origin, random);
        const Vec3 direction = target - origin;
        if (!is_finite(direction) || !(max_abs(direction) > 0)) continue;
        rays.push_back({origin, direction});
        rays.back().set_time(time);
    }
    return rays;
}

void add_rays_at_borders(const Intersector& exact, const CameraRays& camera,
                         const std::vector<Vec2>& pixels, std::size_t limit,
                         std::vector<Ray>& rays) {
    const ImagePlane plane(exact, camera);
    for (std::size_t i = 1; i < pixels.size() && rays.size() + 1 < limit; ++i) {
        Vec2 a = pixels[i - 1], b = pixels[i];
        if (plane.at(a) == plane.at(b)) continue;
        plane.approach_edge(a, b);
        rays.push_back(plane.through(a));
        rays.push_back(plane.through(b));
    }
}

}  // namespace etalon
