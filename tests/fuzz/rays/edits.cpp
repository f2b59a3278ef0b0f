#include "tests/fuzz/rays/edits.h"

#include <fmt/format.h>

#include "core/scene/transformed.h"

namespace etalon::fuzz {
namespace {

/// Returns whether a number is of a usual size. With such numbers no product in a kernel leaves the
/// range of double, and a scaled ray has the same bits of t.
bool is_usual(double x) {
    return x == 0 || (std::abs(x) > 0x1p-60 && std::abs(x) < 0x1p60);
}

bool is_usual(const Ray& ray) {
    for (int k = 0; k < 3; ++k) {
        if (!is_usual(ray.origin[k]) || !is_usual(ray.direction[k])) return false;
    }
    return true;
}

Edited scaled(const Scene& scene, const std::vector<Ray>& rays, const std::vector<Hit>& hits,
              Random& random) {
    const int k = static_cast<int>(random.index(61)) - 30;
    const double factor = std::ldexp(1, k);
    Edited e{fmt::format("scaled by 2^{}", k), transformed(scene, factor), {}, {}};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!is_usual(rays[i])) continue;
        Ray ray = rays[i];
        ray.origin *= factor;
        ray.direction *= factor;
        e.rays.push_back(ray);
        e.expected.push_back(hits[i]);
    }
    return e;
}

bool is_small_and_whole(const Vec3& v) {
    const auto is = [](double x) { return std::abs(x) < 0x1p20 && std::round(4 * x) == 4 * x; };
    return is(v.x) && is(v.y) && is(v.z);
}

/// Translates a scene of whole numbers. With other numbers the sums would be rounded.
Edited moved(const Scene& scene, const std::vector<Ray>& rays, const std::vector<Hit>& hits,
             Random& random) {
    const Vec3 offset(random.index(2001) - 1000.0,
                      std::ldexp(random.sign(), static_cast<int>(random.index(28))), 0);
    Edited e{fmt::format("moved by {} {} {}", offset.x, offset.y, offset.z),
             transformed(scene, 1, offset),
             {},
             {}};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!is_small_and_whole(rays[i].origin)) continue;
        Ray ray = rays[i];
        ray.origin += offset;
        e.rays.push_back(ray);
        e.expected.push_back(hits[i]);
    }
    return e;
}

Edited permuted(const Scene& scene, const std::vector<Ray>& rays, const std::vector<Hit>& hits,
                Random& random) {
    Edited e{"permuted", scene, rays, hits};
    std::vector<Primitive> list = scene.geometry.primitives.list();
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.index(i)]);
    e.scene.geometry.primitives = PrimitiveRuns(list);
    e.compares_t_only = true;
    return e;
}

/// Cuts every triangle from its first vertex to the midpoint of the opposite edge, which is exact.
Edited split(const Scene& scene, const std::vector<Ray>& rays, const std::vector<Hit>& hits) {
    Edited e{"with its triangles cut in two", scene, {}, {}};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (rays[i].tmin != 0 || rays[i].tmax != infinity)
            continue;  // t is not the same to the bit
        e.rays.push_back(rays[i]);
        e.expected.push_back(hits[i]);
    }
    Geometry& g = e.scene.geometry;
    for (const Primitive& p : scene.geometry.primitives) {
        if (p.kind != kind_of<Triangle>()) continue;
        const auto [a, b, c] = scene.geometry.get<Triangle>(p).vertices;
        const std::uint32_t middle = g.add_vertex(0.5 * (g.vertex(b) + g.vertex(c)));
        g.add(Triangle{{a, b, middle}}, 0, p.sides);
        g.add(Triangle{{a, middle, c}}, 0, p.sides);
    }
    std::vector<Primitive> kept;
    for (std::uint32_t i = 0; i < g.primitives.size(); ++i) {
        const Primitive p = g.primitives[i];
        if (p.kind != kind_of<Triangle>() || i >= scene.geometry.primitives.size())
            kept.push_back(p);
    }
    g.primitives = PrimitiveRuns(kept);
    e.compares_t_only = true;
    e.tolerance = 2 * t_tolerance;
    return e;
}

bool is_as_expected(const Hit& hit, const Hit& expected, const Edited& e) {
    const bool found = hit.primitive != no_index;
    if (found != (expected.primitive != no_index)) return false;
    if (!found) return true;
    if (!e.compares_t_only &&
        (hit.primitive != expected.primitive || hit.instance != expected.instance)) {
        return false;
    }
    return std::abs(hit.t - expected.t) <= e.tolerance * expected.t;
}

}  // namespace

std::optional<Edited> edited(const Scene& scene, const std::vector<Ray>& rays,
                             const std::vector<Hit>& hits, const AdversarialNumbers& numbers) {
    Random& random = numbers.random();
    const bool is_exact = numbers.palette() == Palette::whole;
    switch (random.index(4)) {
        case 0:
            if (numbers.palette() == Palette::wild) return std::nullopt;
            return scaled(scene, rays, hits, random);
        case 1:
            return permuted(scene, rays, hits, random);
        case 2:
            return is_exact ? std::optional(moved(scene, rays, hits, random)) : std::nullopt;
        default:
            return is_exact ? std::optional(split(scene, rays, hits)) : std::nullopt;
    }
}

std::optional<Finding> find_change(const Edited& e) {
    const std::vector<Hit> hits = reference_hits(e.scene, e.rays);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (is_as_expected(hits[i], e.expected[i], e)) continue;
        return Finding{e.rays[i], fmt::format("{}: expected {}, found {}", e.name,
                                              to_string(e.expected[i]), to_string(hits[i]))};
    }
    return find_disparity(e.scene, e.rays, hits);
}

}  // namespace etalon::fuzz
