#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/meshes.h"

using namespace etalon;

namespace {

/// Tests every face, except those whose boxes a ray passes at a distance far above rounding errors.
class BruteForce {
  public:
    explicit BruteForce(const Scene& scene) : scene_(scene) {
        for (std::uint32_t id = 0; id < scene.geometry.primitives.size(); ++id) {
            const Box3 box = primitive_bounds(scene.geometry, id);
            if (box.isEmpty()) continue;
            boxes_.push_back(box);
            ids_.push_back(id);
            extent_ = std::max({extent_, max_abs(box.min), max_abs(box.max)});
        }
    }

    bool hits(const Ray& ray) const {
        const RayQuery query(ray);
        const Vec3 inverse(1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z);
        const Vec3 slack = 1e-9 * (extent_ + max_abs(ray.origin)) * abs(inverse);
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            double entry = 0, exit = infinity;
            for (int k = 0; k < 3; ++k) {
                const double a = (boxes_[i].min[k] - ray.origin[k]) * inverse[k];
                const double b = (boxes_[i].max[k] - ray.origin[k]) * inverse[k];
                entry = std::max(entry, std::min(a, b) - slack[k]);
                exit = std::min(exit, std::max(a, b) + slack[k]);
            }
            if (entry <= exit && primitive_first_hit(scene_.geometry, ids_[i], query) <= infinity)
                return true;
        }
        return false;
    }

  private:
    const Scene& scene_;
    std::vector<Box3> boxes_;
    std::vector<std::uint32_t> ids_;
    double extent_ = 0;
};

/// Returns in turn a vertex, a point of an edge, and its midpoint, as exactly as doubles allow.
Vec3 target(const ClosedMesh& mesh, int i, Random& random) {
    const std::vector<Vec3>& face =
        mesh.faces[static_cast<std::size_t>(random.index(mesh.faces.size()))];
    const auto k = static_cast<std::size_t>(random.index(face.size()));
    const Vec3 &a = face[k], &b = face[(k + 1) % face.size()];
    if (i % 3 == 0) return a;
    return a + (i % 3 == 1 ? random.uniform() : 0.5) * (b - a);
}

std::vector<ClosedMesh> meshes() {
    const Vec3 far_away(148376, 1234, -223423), origin(0);
    return {
        uv_sphere("triangles", origin, Vec3(1), Faces::triangles),
        uv_sphere("quads and triangles", origin, Vec3(1), Faces::mixed),
        uv_sphere("triangles, far from the origin", far_away, Vec3(2), Faces::triangles),
        uv_sphere("quads and triangles, far from the origin", far_away, Vec3(2), Faces::mixed),
        uv_sphere("slivers", origin, Vec3(1e-3, 1, 1e3), Faces::triangles),
        uv_sphere("slivers and sliver quads", origin, Vec3(1e-3, 1, 1e3), Faces::mixed),
    };
}

void set_sides(Geometry& geometry, Sides sides) {
    std::vector<Primitive> primitives = geometry.primitives.list();
    for (Primitive& p : primitives) p.sides = sides;
    geometry.primitives = PrimitiveRuns(primitives);
}

void require_no_leaks(int rays_per_mesh) {
    for (ClosedMesh& mesh : meshes()) {
        const BruteForce brute_force(mesh.scene);
        Random random(12);
        int leaks = 0;
        for (int i = 0; i < rays_per_mesh; ++i) {
            const Vec3 origin = mesh.centre + 0.25 * mesh.radius * random.in_cube();
            const Ray ray{origin, target(mesh, i, random) - origin};
            // From inside only the backs of faces are visible.
            const Sides sides = i % 2 == 0 ? Sides::both : Sides::back;
            set_sides(mesh.scene.geometry, sides);
            leaks += !brute_force.hits(ray);
        }
        CAPTURE(mesh.name, rays_per_mesh);
        REQUIRE(leaks == 0);
    }
}

}  // namespace

TEST_CASE("Closed meshes: given rays from inside at corners and edges, then none gets out") {
    require_no_leaks(600);
}

TEST_CASE("Closed meshes: given very many rays from inside, then none gets out", "[long]") {
    require_no_leaks(60000);
}
