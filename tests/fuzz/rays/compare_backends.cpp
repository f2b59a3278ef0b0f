#include "tests/fuzz/rays/compare_backends.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/intersect/backend_roles.h"
#include "core/intersect/intersector.h"
#include "core/oracle/oracle.h"
#include "embree_backend/embree_backends.h"
#include "native_accel/native_backends.h"

namespace etalon::fuzz {
namespace {

const std::vector<Backend>& exact_backends() {
    static const std::vector<Backend> list = [] {
        std::vector<Backend> all;
        for (const auto& part : {native_backends(), embree_backends()}) {
            for (const Backend& b : part) {
                if (b.exact) all.push_back(b);
            }
        }
        return all;
    }();
    return list;
}

const Backend& reference() {
    return *std::ranges::find(exact_backends(), reference_backend, &Backend::name);
}

bool found(const Hit& hit) {
    return hit.primitive != no_index;
}

bool same_bits(const Hit& a, const Hit& b) {
    if (!found(a) || !found(b)) return found(a) == found(b);
    return a.primitive == b.primitive && a.instance == b.instance &&
           std::bit_cast<std::uint64_t>(a.t) == std::bit_cast<std::uint64_t>(b.t);
}

std::optional<Finding> compare(const Backend& backend, const Intersector& intersector,
                               const std::vector<Ray>& rays, const std::vector<Hit>& expected) {
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    intersector.closest(rays, hits);
    intersector.occluded(rays, blocked);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool occlusion = found(expected[i]), is_asked_alone = i % 4 == 0;
        const Hit alone =
            is_asked_alone ? intersector.closest(rays[i]).value_or(Hit{0, no_index}) : hits[i];
        const bool is_blocked = is_asked_alone ? intersector.occluded(rays[i]) : blocked[i] != 0;
        if (same_bits(hits[i], expected[i]) && same_bits(alone, expected[i]) &&
            (blocked[i] != 0) == occlusion && is_blocked == occlusion) {
            continue;
        }
        return Finding{
            rays[i],
            fmt::format("{}: expected {}, found {} in a batch, {} alone, occluded {} and {}",
                        backend.name, to_string(expected[i]), to_string(hits[i]), to_string(alone),
                        blocked[i], is_blocked)};
    }
    return std::nullopt;
}

/// Returns what is wrong with a hit that the oracle has decided; empty if it is right.
std::string error_of(const Hit& hit, const OracleAnswer& truth) {
    const bool is_hit = truth.kind == OracleAnswer::hit;
    if (found(hit) != is_hit) return "hit or miss";
    if (!is_hit) return "";
    if (!std::ranges::binary_search(truth.tied, key_of(hit.primitive, hit.instance)))
        return "primitive";
    const double tolerance = truth.tied.size() > 1 ? 4 * t_tolerance : t_tolerance;
    const double few_ulp = 4 * std::numeric_limits<double>::denorm_min();  // of the smallest
    const bool is_near = std::abs(hit.t - truth.t) <= few_ulp;
    return is_near || truth.relative_error(hit.t) <= tolerance ? "" : "distance";
}

std::string to_string(const OracleAnswer& truth) {
    if (truth.kind == OracleAnswer::miss) return "nothing";
    return fuzz::to_string(Hit{truth.t, truth.primitive, truth.instance});
}

std::string to_string(const Vec3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

}  // namespace

std::string to_string(const Hit& hit) {
    if (!found(hit)) return "nothing";
    const std::string instance =
        hit.instance == no_index ? "" : fmt::format(" of instance {}", hit.instance);
    return fmt::format("primitive {}{} at {}", hit.primitive, instance, hit.t);
}

std::string to_string(const Ray& ray) {
    return fmt::format("{} {} {} {} {}", to_string(ray.origin), to_string(ray.direction), ray.tmin,
                       ray.tmax, ray.time() * 0x1p-24);
}

std::vector<Hit> reference_hits(const Scene& scene, const std::vector<Ray>& rays) {
    const auto intersector = reference().build(scene.geometry);
    std::vector<Hit> hits;
    for (const Ray& ray : rays)
        hits.push_back(intersector->closest(ray).value_or(Hit{0, no_index}));
    return hits;
}

std::optional<Finding> find_disparity(const Scene& scene, const std::vector<Ray>& rays,
                                      const std::vector<Hit>& reference) {
    for (const Backend& backend : exact_backends()) {
        const auto intersector = backend.build(scene.geometry);
        if (auto finding = compare(backend, *intersector, rays, reference)) return finding;
    }
    return std::nullopt;
}

std::optional<Finding> find_error(const Scene& scene, const std::vector<Ray>& rays,
                                  const std::vector<Hit>& reference, std::uint64_t& undecided) {
    const Oracle oracle(scene.geometry);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const OracleAnswer truth = oracle.closest(rays[i]);
        if (truth.kind == OracleAnswer::undecidable) {
            ++undecided;
            continue;
        }
        const std::string error = error_of(reference[i], truth);
        if (error.empty()) continue;
        return Finding{rays[i], fmt::format("wrong {}: the oracle says {}, the kernels {}", error,
                                            to_string(truth), to_string(reference[i]))};
    }
    return std::nullopt;
}

std::optional<Finding> find_difference(const Scene& scene, const std::vector<Ray>& rays) {
    const std::vector<Hit> hits = reference_hits(scene, rays);
    if (auto finding = find_disparity(scene, rays, hits)) return finding;
    std::uint64_t undecided = 0;
    return find_error(scene, rays, hits, undecided);
}

}  // namespace etalon::fuzz
