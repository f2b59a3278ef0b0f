// Surfaces with holes: every exact backend and the oracle find the remaining surface, also if
// several surfaces coincide.
#include "core/intersect/cut_outs.h"
#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/numerics/random.h"
#include "core/oracle/oracle.h"
#include "core/scene/transformed.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Holes in a checkerboard pattern, smaller for higher material numbers; for shadow rays half of
/// the other squares are also holes.
class Chessboards : public CutOuts {
  public:
    explicit Chessboards(double unit = 1) : unit_(unit) {}

    bool is_hole(const Geometry&, const SurfacePoint& point, bool for_shadow) const override {
        const Square at = square(point.position, point.material);
        return at.is_even || (for_shadow && at.is_even_column);
    }

    /// Returns whether a point is too close to the border of a square to be classified.
    bool is_doubtful_at(const Vec3& p, std::uint32_t material) const {
        const auto near = [&](double x) {
            const double place = x / unit_ * fields(material);
            return std::abs(place - std::round(place)) < 1e-6;
        };
        return near(p.x) || near(p.y);
    }

  private:
    struct Square {
        bool is_even, is_even_column;
    };

    static double fields(std::uint32_t material) { return 2.5 * (material + 1); }

    Square square(const Vec3& p, std::uint32_t material) const {
        const double column = std::floor(p.x / unit_ * fields(material)),
                     row = std::floor(p.y / unit_ * fields(material));
        return {std::fmod(std::abs(column + row), 2) == 0, std::fmod(std::abs(column), 2) == 0};
    }

    double unit_;
};

constexpr int layers = 5;

/// Coincident copies of two triangles at z = 0, most of them with holes; others that cross them,
/// and a wall behind.
Geometry layered_squares(Random& random) {
    Geometry g;
    for (const Vec3& p :
         {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(-1, -0.5, -1),
          Vec3(1, -0.5, -1), Vec3(0.2, 1.5, 1), Vec3(-9, -9, 2), Vec3(9, -9, 2), Vec3(0, 9, 2)}) {
        g.add_vertex(p);
    }
    for (int layer = 0; layer < layers; ++layer) {
        const Sides sides = random.one_in(6) ? Sides::both : Sides::cut_out;
        const std::uint32_t material = random.index(4);
        g.add(Triangle{{0, 1, 2}}, material, sides);
        g.add(Triangle{{0, 2, 3}}, material, sides);
        g.add(Triangle{{4, 5, 6}}, material, sides);
    }
    g.add(Sphere{Vec3(0, 0, 1), 0.5}, 0);
    if (random.one_in(2)) g.add(Triangle{{7, 8, 9}}, 0);
    g.cut_outs = std::make_shared<const Chessboards>();
    return g;
}

/// The same as an object with several instances, two of which coincide.
Geometry with_instances(Random& random) {
    Geometry g = layered_squares(random);
    const Affine first{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.25, 0, -1}},
        mirrored{{-0.5, 0, 0}, {0, 0.25, 0.25}, {0, 0, 1}, {-0.5, 0.5, -0.5}};
    g.objects.push_back(layered_squares(random));
    for (const Affine& map : {first, first, mirrored}) g.instances.emplace_back(map, 0);
    return g;
}

Geometry without_holes(Geometry geometry) {
    geometry.cut_outs = nullptr;
    for (Geometry& object : geometry.objects) object.cut_outs = nullptr;
    return geometry;
}

/// The hit of a ray by the rule for ties, or that it passes too close to the border of a hole.
/// Holes are evaluated independently of the kernels.
struct Expected {
    bool is_doubtful = false;
    std::optional<Hit> hit;
    bool passes_hole = false;
};

Expected expected_hit(const Geometry& whole, const Chessboards& boards, const Ray& ray) {
    Expected expected;
    const auto offer = [&](std::uint32_t primitive, std::uint32_t instance) {
        const double t = first_hit(whole, key_of(primitive, instance), ray);
        if (!(t <= ray.tmax)) return;
        const Geometry& holder = whole.holder(instance);
        const Primitive p = holder.primitives[primitive];
        if (p.sides == Sides::cut_out) {
            const Ray local =
                instance == no_index ? ray : to_object(whole.instances[instance], instance, ray);
            SurfacePoint point{};
            point.position = local.origin + t * local.direction;
            point.material = p.material;
            if (boards.is_doubtful_at(point.position, p.material)) expected.is_doubtful = true;
            if (boards.is_hole(holder, point, ray.is_shadow())) {
                expected.passes_hole = true;
                return;
            }
        }
        if (!expected.hit || t < expected.hit->t) expected.hit = Hit{t, primitive, instance};
    };
    for (std::uint32_t p = 0; p < whole.primitives.size(); ++p) offer(p, no_index);
    for (std::uint32_t i = 0; i < whole.instances.size(); ++i) {
        for (std::uint32_t p = 0; p < whole.holder(i).primitives.size(); ++p) offer(p, i);
    }
    return expected;
}

Ray any_ray(Random& random) {
    const Vec3 from(random.uniform(-2, 2), random.uniform(-2, 2), random.sign() * 3);
    Vec3 to(random.uniform(-1, 1), random.uniform(-1, 1), random.one_in(2) ? 0 : random.uniform());
    if (random.one_in(8)) to.y = to.x;  // the edge that two triangles share
    Ray ray{from, to - from};
    if (random.one_in(4)) ray.tmax = random.uniform(0.5, 1.5);
    if (random.one_in(2)) ray.set_shadow();
    if (random.one_in(2)) ray.set_coherent();
    return ray;
}

/// A geometry, and rays whose hits are known.
struct Aimed {
    Geometry geometry;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::size_t through_holes = 0;  ///< rays that pass one
};

Aimed aimed_at(Geometry geometry, Random& random, int count) {
    Aimed aimed{std::move(geometry), {}, {}};
    const Geometry whole = without_holes(aimed.geometry);
    const auto& boards = static_cast<const Chessboards&>(*aimed.geometry.cut_outs);
    for (int i = 0; i < count; ++i) {
        const Ray ray = any_ray(random);
        const Expected expected = expected_hit(whole, boards, ray);
        if (expected.is_doubtful) continue;
        aimed.rays.push_back(ray);
        aimed.hits.push_back(expected.hit.value_or(Hit{0, no_index}));
        aimed.through_holes += expected.passes_hole ? 1 : 0;
    }
    return aimed;
}

/// Counts rays for which any query of the backend differs from the expected result.
std::size_t count_wrong(const Backend& backend, const Aimed& aimed) {
    const auto intersector = backend.build(aimed.geometry);
    std::vector<Hit> hits(aimed.rays.size());
    std::vector<std::uint8_t> blocked(aimed.rays.size());
    intersector->closest(aimed.rays, hits);
    intersector->occluded(aimed.rays, blocked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < aimed.rays.size(); ++i) {
        const Ray& ray = aimed.rays[i];
        const Hit& expected = aimed.hits[i];
        const bool is_hit = expected.primitive != no_index;
        const Hit alone = intersector->closest(ray).value_or(Hit{0, no_index});
        TraversalCost cost;
        const Hit counted = intersector->closest(ray, cost).value_or(Hit{0, no_index});
        wrong += !same(hits[i], expected) || !same(alone, expected) || !same(counted, expected) ||
                 (blocked[i] != 0) != is_hit || intersector->occluded(ray) != is_hit;
    }
    return wrong;
}

}  // namespace

TEST_CASE("Exact backends find what holes leave of surfaces in one place", "[cut_outs]") {
    std::size_t rays = 0, through_holes = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        Random random(17, seed);
        const Aimed aimed = aimed_at(
            seed % 2 == 0 ? layered_squares(random) : with_instances(random), random, 2000);
        for (const Backend& backend : exact_backends()) {
            CAPTURE(backend.name);
            CHECK(count_wrong(backend, aimed) == 0);
        }
        rays += aimed.rays.size();
        through_holes += aimed.through_holes;
    }
    CHECK(rays > 20000);
    CHECK(through_holes > 1000);
}

TEST_CASE("Embree's own kernels leave surfaces with holes to the exact ones", "[cut_outs]") {
    Random random(18);
    Geometry g = layered_squares(random);
    Geometry cut_out;
    cut_out.vertices = g.vertices;
    cut_out.cut_outs = g.cut_outs;
    for (const Primitive p : g.primitives) {
        if (p.sides == Sides::cut_out) cut_out.add(g.get<Triangle>(p), p.material, p.sides);
    }
    const Aimed aimed = aimed_at(cut_out, random, 2000);
    CHECK(aimed.through_holes > 1000);
    CHECK(count_wrong(backend_named("embree-builtin"), aimed) == 0);
}

TEST_CASE("The oracle knows of holes", "[cut_outs][oracle]") {
    Random random(19);
    const Aimed aimed = aimed_at(with_instances(random), random, 1000);
    const Oracle oracle(aimed.geometry);
    std::size_t decided = 0;
    for (std::size_t i = 0; i < aimed.rays.size(); ++i) {
        const OracleAnswer answer = oracle.closest(aimed.rays[i]);
        if (answer.kind == OracleAnswer::undecidable) continue;
        ++decided;
        const Hit& expected = aimed.hits[i];
        REQUIRE((answer.kind == OracleAnswer::hit) == (expected.primitive != no_index));
        if (answer.kind != OracleAnswer::hit) continue;
        const HitKey key = key_of(expected.primitive, expected.instance);
        REQUIRE(std::ranges::find(answer.tied, key) != answer.tied.end());
    }
    CHECK(decided > 900);
}

TEST_CASE("Holes are in the same places after scaling by a power of two", "[cut_outs]") {
    Random random(20);
    const Aimed aimed = aimed_at(layered_squares(random), random, 1000);
    Scene scene;
    scene.geometry = aimed.geometry;
    for (const double factor : {0x1p-20, 0x1p13}) {
        Aimed scaled = aimed;
        scaled.geometry = transformed(scene, factor).geometry;
        scaled.geometry.cut_outs = std::make_shared<const Chessboards>(factor);
        for (Ray& ray : scaled.rays) {
            ray.origin *= factor;
            ray.direction *= factor;
        }
        for (const Backend& backend : exact_backends()) {
            CAPTURE(factor, backend.name);
            CHECK(count_wrong(backend, scaled) == 0);
        }
    }
}
