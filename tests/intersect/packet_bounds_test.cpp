// Compares packet bounds with single rays aimed past boxes, at their corners and next to them, for
// every instruction set that the machine has.
#include "core/intersect/packet_bounds.h"

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/each_instruction_set.h"

using namespace etalon;
using namespace etalon::test;

namespace {

struct RaySet {
    std::vector<Ray> rays;
    int dominant;
};

/// Returns rays that start near a point in similar directions, some of them towards one point;
/// lengths are of few sizes, so that rays and boxes are often close to each other.
RaySet alike_rays(Random& random) {
    const double scale = std::exp2(random.uniform(-40, 40));
    const double from_spread = random.one_in(3) ? 0 : random.magnitude(-9, 0);
    const double spread = random.one_in(3) ? 0 : random.magnitude(-9, 0);
    const Vec3 from = scale * random.in_cube(4), way = scale * random.direction();
    const bool to_point = random.one_in(2);
    RaySet set;
    set.dominant = dominant_axis(way);
    const std::size_t count = 1 + random.index(RayPacket::most);
    while (set.rays.size() < count) {
        const Vec3 origin = from + from_spread * scale * random.in_cube();
        const Vec3 aim = to_point ? from + way - origin : way;
        const Vec3 direction = aim + spread * scale * random.in_cube();
        if (dominant_axis(direction) == set.dominant) set.rays.push_back({origin, direction});
    }
    return set;
}

PacketBounds bounds_of(const RaySet& set) {
    RayPacket packet;
    packet.dominant = set.dominant;
    for (const Ray& ray : set.rays) packet.add(packet.count, ray, ray.direction);
    return PacketBounds(packet);
}

/// Returns a box, thin or not, with a corner within rounding error of a point of the ray.
Box3 box_at(const Ray& ray, Random& random) {
    Vec3 corner = ray.origin + random.uniform(0, 3) * ray.direction;
    for (int k = 0; k < 3; ++k) {
        if (random.one_in(2)) corner[k] = std::nextafter(corner[k], random.sign() * infinity);
    }
    Vec3 other = corner;
    for (int k = 0; k < 3; ++k) {
        if (!random.one_in(4))
            other[k] += random.sign() * max_abs(ray.direction) * random.uniform();
    }
    Box3 box(corner, corner);
    box.extendBy(other);
    return box;
}

std::size_t count_near(const PacketBounds& bounds, const std::vector<Box3>& boxes) {
    BoxColumns columns;
    for (const Box3& box : boxes) columns.add(box);
    std::vector<std::uint32_t> numbers(boxes.size());
    return bounds.find_near(columns, numbers.data());
}

/// Returns the number of boxes that a ray touches and its packet misses.
std::size_t lost_boxes(std::size_t count) {
    Random random(31);
    std::size_t lost = 0;
    for (std::size_t done = 0; done < count;) {
        const RaySet set = alike_rays(random);
        const PacketBounds bounds = bounds_of(set);
        if (!bounds.goes_one_way()) continue;
        std::vector<Box3> boxes;
        for (const Ray& ray : set.rays) boxes.push_back(box_at(ray, random));
        lost += boxes.size() - count_near(bounds, boxes);
        done += boxes.size();
    }
    return lost;
}

}  // namespace

TEST_CASE("Packet bounds: a box that a ray touches is not missed") {
    for_each_target([] { CHECK(lost_boxes(100'000) == 0); });
}

TEST_CASE("Packet bounds: none of ten million boxes that rays touch is missed", "[long]") {
    CHECK(lost_boxes(10'000'000) == 0);
}

TEST_CASE("Packet bounds: boxes beside or behind rays that go one way are culled") {
    RaySet set{{}, 2};
    for (int i = 0; i < 64; ++i) {
        set.rays.push_back({Vec3(0), Vec3(0.01 * (i % 8), 0.01 * (i / 8), 1)});
    }
    for_each_target([&] {
        const PacketBounds bounds = bounds_of(set);
        const auto box_of = [](const Vec3& centre) {
            return Box3(centre - Vec3(0.25), centre + Vec3(0.25));
        };
        BoxColumns boxes;
        for (const Vec3& centre : {Vec3(1, 0, 5), Vec3(0.2, 0.2, 5), Vec3(0, -1, 5), Vec3(0, 0, -5),
                                   Vec3(0, 0, 0), Vec3(100, 0, 0)}) {
            boxes.add(box_of(centre));
        }
        std::array<std::uint32_t, 6> near{};
        REQUIRE(bounds.find_near(boxes, near.data()) == 2);
        CHECK(near[0] == 1);
        CHECK(near[1] == 4);
    });
}

TEST_CASE("Packet bounds: infinite boxes are never culled") {
    const PacketBounds bounds =
        bounds_of({{{Vec3(0), Vec3(0, 0, 1)}, {Vec3(1), Vec3(0, 1, 1)}}, 2});
    const Box3 whole(Vec3(-infinity), Vec3(infinity));
    const Box3 slab(Vec3(5, -infinity, -infinity), Vec3(5, infinity, infinity));
    CHECK(count_near(bounds, {whole, slab}) >= 1);
}

TEST_CASE("Packet bounds: nothing is said of rays that go both ways") {
    const auto says = [](const std::vector<Ray>& rays) {
        return bounds_of({rays, 2}).goes_one_way();
    };
    CHECK(says({{Vec3(0), Vec3(0, 0, 1)}}));
    CHECK(says({{Vec3(0), Vec3(0, 0, -1)}, {Vec3(0), Vec3(0, 0, -2)}}));
    CHECK_FALSE(says({{Vec3(0), Vec3(0, 0, 1)}, {Vec3(0), Vec3(0, 0, -1)}}));
}
