#include "tests/backends/test_rays.h"

#include "core/intersect/kernels.h"

namespace etalon::test {
namespace {

/// Chooses origins and targets with a scene's own features and size.
class RayMaker {
  public:
    RayMaker(const Scene& scene, Random& random)
        : scene_(scene),
          random_(random),
          vertices_(scene.geometry.vertices.begin(), scene.geometry.vertices.end()) {
        const std::span<const Vec3> corners = scene.geometry.all<Polygon>().corners();
        vertices_.insert(vertices_.end(), corners.begin(), corners.end());
        for (std::uint32_t id = 0; id < scene.geometry.primitives.size(); ++id) {
            const Box3 box = primitive_bounds(scene.geometry, id);
            if (box.isEmpty() || !is_finite(box.min) || !is_finite(box.max)) continue;
            bounded_.push_back(box);
            all_.extendBy(box);
        }
        if (all_.isEmpty()) all_ = Box3(Vec3(-1), Vec3(1));
        radius_ = std::max(max_abs(all_.size()), 1e-3 * max_abs(all_.center()));
        if (radius_ == 0) radius_ = 1;
    }

    Ray next() {
        const Vec3 to = target();
        Ray ray{origin(), Vec3(0)};
        ray.direction = to - ray.origin;
        if (random_.one_in(8)) make_axis_parallel(ray, to);
        if (random_.one_in(16)) add_denormal(ray);
        if (max_abs(ray.direction) == 0) ray.direction = random_.direction();
        if (random_.one_in(2)) {
            ray.direction *= random_.magnitude(-3, 3) / max_abs(ray.direction);
        }
        if (random_.one_in(6)) add_range(ray, to);
        return ray;
    }

  private:
    Vec3 in(const Box3& box) {
        const Vec3 s = box.size();
        return box.min + Vec3(s.x * random_.uniform(0, 1), s.y * random_.uniform(0, 1),
                              s.z * random_.uniform(0, 1));
    }

    Vec3 corner_of(const Box3& box) {
        return {random_.one_in(2) ? box.min.x : box.max.x,
                random_.one_in(2) ? box.min.y : box.max.y,
                random_.one_in(2) ? box.min.z : box.max.z};
    }

    const Vec3& vertex() { return vertices_[random_.index(vertices_.size())]; }

    Vec3 on_edge() {
        const auto& triangles = scene_.geometry.all<Triangle>();
        if (triangles.empty()) return vertex();
        const TriangleIndices t = triangles[random_.index(triangles.size())];
        const Vec3 a = scene_.geometry.vertex(t[0]);
        const Vec3 b = scene_.geometry.vertex(t[1]);
        return a + (random_.one_in(4) ? 0.5 : random_.uniform(0, 1)) * (b - a);
    }

    /// Returns a point on a sphere's silhouette as seen from near the scene's centre, to double
    /// precision.
    Vec3 on_silhouette() {
        const auto& spheres = scene_.geometry.all<Sphere>();
        if (spheres.empty()) return in(all_);
        const Sphere& s = spheres[random_.index(spheres.size())];
        Vec3 u, v;
        const Vec3 towards = s.centre - all_.center();
        const double length = std::sqrt(towards.dot(towards));
        orthonormal_basis(length > 0 ? towards / length : Vec3(0, 0, 1), u, v);
        return s.centre + s.radius * (random_.one_in(2) ? u : v);
    }

    Vec3 target() {
        const bool has_vertices = !vertices_.empty();
        switch (random_.index(6)) {
            case 0:
                return has_vertices ? vertex() : on_silhouette();
            case 1:
                return has_vertices ? on_edge() : on_silhouette();
            case 2:
                return on_silhouette();
            case 3:
                return bounded_.empty() ? in(all_) : corner_of(random_box());
            case 4:
                return bounded_.empty() ? in(all_) : in(random_box());
            default:
                return in(all_);
        }
    }

    const Box3& random_box() { return bounded_[random_.index(bounded_.size())]; }

    Vec3 origin() {
        const Vec3 centre = all_.center();
        switch (random_.index(8)) {
            case 0:
                return centre + 1e5 * radius_ * random_.direction();
            case 1:
                return centre + 1e9 * radius_ * random_.direction();
            case 2:
                return target();
            case 3:
                return centre;
            case 4:
                return centre + 3 * radius_ * random_.direction();
            case 5:
                return corner_of(all_);
            default:
                return in(all_);
        }
    }

    void make_axis_parallel(Ray& ray, const Vec3& to) {
        const int axis = static_cast<int>(random_.index(3));
        ray.direction = Vec3(0);
        ray.direction[axis] = random_.one_in(2) ? 1 : -1;
        if (random_.one_in(2)) ray.direction = -ray.direction;  // which makes the zeros negative
        if (!random_.one_in(4)) ray.origin = to - 2 * radius_ * ray.direction;
    }

    void add_denormal(Ray& ray) {
        ray.direction[static_cast<int>(random_.index(3))] = random_.one_in(2) ? 5e-324 : -1e-310;
    }

    void add_range(Ray& ray, const Vec3& to) {
        const double t = (to - ray.origin).dot(ray.direction) / ray.direction.dot(ray.direction);
        ray.tmin = random_.one_in(4) ? -std::abs(t) : random_.uniform(0, 1) * t;
        if (random_.one_in(2)) ray.tmax = ray.tmin + std::abs(t) * random_.uniform(0, 2);
    }

    const Scene& scene_;
    Random& random_;
    std::vector<Vec3> vertices_;
    std::vector<Box3> bounded_;
    Box3 all_;
    double radius_;
};

}  // namespace

std::vector<Ray> make_rays(const Scene& scene, std::size_t count, Random& random) {
    RayMaker maker(scene, random);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) rays.push_back(maker.next());
    return rays;
}

std::vector<Ray> around_hit(const Ray& ray, double t) {
    std::vector<Ray> rays{ray};
    for (const double limit : {std::nextafter(t, -infinity), t, std::nextafter(t, infinity)}) {
        rays.push_back({ray.origin, ray.direction, ray.tmin, limit});
        rays.push_back({ray.origin, ray.direction, limit, ray.tmax});
    }
    return rays;
}

}  // namespace etalon::test
