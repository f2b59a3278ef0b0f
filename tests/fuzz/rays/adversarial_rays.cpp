#include "tests/fuzz/rays/adversarial_rays.h"

#include "core/test_rays/targets.h"

namespace etalon::fuzz {
namespace {

constexpr double finest = -15.5;  // log10 of the smallest relative distance to a silhouette

/// Makes rays of one time, since targets on moving instances depend on it.
class RayMaker {
  public:
    RayMaker(const Scene& scene, const AdversarialNumbers& numbers)
        : numbers_(numbers),
          random_(numbers.random()),
          time_(random_.one_in(4) ? 0 : random_.index(std::size_t{1} << shutter_time_bits)),
          vertices_(scene.geometry.vertices.begin(), scene.geometry.vertices.end()) {
        for (std::uint32_t item = 0; item < scene.geometry.item_count(); ++item) {
            for (Target& t : targets_of(scene.geometry, item, finest, time_)) {
                targets_.push_back(std::move(t));
            }
        }
        const std::span<const Vec3> corners = scene.geometry.all<Polygon>().corners();
        vertices_.insert(vertices_.end(), corners.begin(), corners.end());
    }

    Ray next() {
        Ray ray{origin(), Vec3(0)};
        const Vec3 to = target(ray.origin);
        ray.direction = random_.one_in(8) ? numbers_.direction() : to - ray.origin;
        if (random_.one_in(8)) ray.direction[random_.axis()] = 0;
        if (random_.one_in(16)) ray.direction[random_.axis()] = random_.sign() * 5e-324;
        if (random_.one_in(4))
            ray.direction *= std::ldexp(1, static_cast<int>(random_.index(81)) - 40);
        if (random_.one_in(32))
            ray.direction *= std::ldexp(1, static_cast<int>(random_.index(2001)) - 1000);
        if (!is_finite(ray.direction) || ray.direction == Vec3(0)) {
            ray.direction = numbers_.direction();
        }
        if (random_.one_in(8)) ray.origin = to - ray.direction;
        if (random_.one_in(6)) end(ray, to);
        ray.set_time(time_);
        for (int k = 0; k < 3; ++k) {
            if (std::abs(ray.origin[k]) < 1e-290) ray.origin[k] = 0;
        }
        return is_finite(ray.origin) ? ray : Ray{to, ray.direction};
    }

  private:
    Vec3 target(const Vec3& from) {
        if (!targets_.empty() && !random_.one_in(4)) {
            const Vec3 p = targets_[random_.index(targets_.size())](from, random_);
            if (is_finite(p)) return p;
        }
        return feature();
    }

    /// Returns a vertex, a point of the line between two vertices, or any point.
    Vec3 feature() {
        if (vertices_.empty() || random_.one_in(6)) return numbers_.point();
        const Vec3 a = vertex();
        return random_.one_in(2) ? a : a + random_.index(5) / 4.0 * (vertex() - a);
    }

    Vec3 origin() {
        switch (random_.index(6)) {
            case 0:
                return target(numbers_.point());
            case 1:
                return feature() + random_.magnitude(0, 9) * random_.direction();
            case 2:
                return feature() + random_.magnitude(6, 22) * random_.direction();
            case 3:
                return numbers_.point_beside(feature());
            default:
                return numbers_.point();
        }
    }

    void end(Ray& ray, const Vec3& to) {
        const double t = (to - ray.origin).dot(ray.direction) / ray.direction.dot(ray.direction);
        if (!std::isfinite(t)) return;
        if (random_.one_in(2)) ray.tmin = random_.index(3) * t / 2;
        if (random_.one_in(2)) ray.tmax = ray.tmin + random_.index(4) * std::abs(t) / 2;
    }

    const Vec3& vertex() { return vertices_[random_.index(vertices_.size())]; }

    const AdversarialNumbers& numbers_;
    Random& random_;
    ShutterTime time_;
    std::vector<Target> targets_;
    std::vector<Vec3> vertices_;
};

}  // namespace

std::vector<Ray> adversarial_rays(const Scene& scene, std::size_t count,
                                  const AdversarialNumbers& numbers) {
    std::vector<Ray> rays;
    while (rays.size() < count) {
        RayMaker maker(scene, numbers);
        for (int i = 0; i < 64 && rays.size() < count; ++i) rays.push_back(maker.next());
    }
    return rays;
}

}  // namespace etalon::fuzz
