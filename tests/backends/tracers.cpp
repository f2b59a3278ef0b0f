#include "tests/backends/tracers.h"

#include <bit>
#include <sstream>

#include "core/intersect/kernels.h"
#include "core/intersect/rescaled_ray.h"
#include "embree_backend/embree_backends.h"
#include "native_accel/native_backends.h"
#include "tests/catch.h"

namespace etalon::test {
namespace {

std::vector<Backend> all() {
    std::vector<Backend> list;
    for (const auto& part : {native_backends(), embree_backends()}) {
        list.insert(list.end(), part.begin(), part.end());
    }
    return list;
}

std::string describe(const std::optional<Hit>& hit) {
    std::ostringstream text;
    text << std::hexfloat;
    hit ? text << "primitive " << hit->primitive << " at " << hit->t : text << "nothing";
    return text.str();
}

std::string describe(const Ray& ray) {
    std::ostringstream text;
    text << std::hexfloat << "ray " << ray.origin << " " << ray.direction << " [" << ray.tmin
         << ", " << ray.tmax << "]";
    return text.str();
}

}  // namespace

bool same(const Hit& a, const Hit& b) {
    if (a.primitive == no_index || b.primitive == no_index) return a.primitive == b.primitive;
    return a.t == b.t && a.primitive == b.primitive && a.instance == b.instance;
}

std::vector<Backend> exact_backends() {
    std::vector<Backend> list = all();
    std::erase_if(list, [](const Backend& b) { return !b.exact; });
    return list;
}

const Backend& backend_named(std::string_view name) {
    static const std::vector<Backend> list = all();
    for (const Backend& backend : list) {
        if (backend.name == name) return backend;
    }
    FAIL("no backend " << name);
    return list.front();
}

std::optional<Hit> brute_force(const Scene& scene, const Ray& ray) {
    if (is_valid(ray) && has_extreme_direction(ray)) {
        const RescaledRay usual(ray);
        std::optional<Hit> hit = brute_force(scene, usual.ray);
        if (hit) hit->t *= usual.unit;
        return hit;
    }
    const RayQuery query(ray);
    std::optional<Hit> best;
    for (std::uint32_t id = 0; id < scene.geometry.primitives.size(); ++id) {
        const double t = primitive_first_hit(scene.geometry, id, query);
        if (t <= ray.tmax && t < infinity && (!best || t < best->t)) best = Hit{t, id};
    }
    return best;
}

bool same_bits(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return !a && !b;
    return a->primitive == b->primitive &&
           std::bit_cast<std::uint64_t>(a->t) == std::bit_cast<std::uint64_t>(b->t);
}

std::string difference(const Intersector& intersector, const Ray& ray,
                       const std::optional<Hit>& expected) {
    const std::optional<Hit> found = intersector.closest(ray);
    const bool occluded = intersector.occluded(ray);
    if (same_bits(found, expected) && occluded == expected.has_value()) return "";
    return describe(ray) + ": expected " + describe(expected) + ", found " + describe(found) +
           (occluded ? ", occluded" : ", not occluded");
}

}  // namespace etalon::test
