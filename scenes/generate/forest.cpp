// A forest of instances: twenty trees, each seen as often as the size asks for, turned, leaning and
// of other sizes.
#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"
#include "scenes/generate/instances.h"

namespace etalon::generate {
namespace {

constexpr std::uint32_t trees = 20;
constexpr std::uint64_t leaves = 388;

/// Returns a point of a crown's outer half, about a ball of radius 1.
Vec3 leaf_place(std::uint64_t key) {
    const Vec3 p = noise_point(key, 0);
    return p.normalized() * (0.75 + 0.25 * noise(key, 9));
}

/// A tree 1 high: a trunk, and leaves in a crown that is wide or slim.
void write_tree(LineWriter& out, std::uint32_t number) {
    const double width = 0.22 + 0.08 * noise(number, 100),
                 height = 0.33 + 0.07 * noise(number, 101);
    out.line("ObjectBegin \"{}\"", number);
    matte(out, {0.35F, 0.25F, 0.16F});
    Mesh trunk;
    trunk.add_prism(6, 0, 1 - height, 0.03, 0.015);
    trunk.write(out);
    matte(out, Color(Vec3(0.2 + 0.1 * noise(number, 102), 0.42 + 0.1 * noise(number, 103), 0.12)));
    Mesh crown;
    for (std::uint64_t leaf = 0; leaf < leaves; ++leaf) {
        const std::uint64_t key = 1000 * (number + 1ULL) + leaf;
        const Vec3 centre = Vec3(0, 1 - height, 0) + leaf_place(key) * Vec3(width, height, width);
        crown.add_triangle(centre + 0.04 * noise_point(key, 1), centre + 0.04 * noise_point(key, 2),
                           centre + 0.04 * noise_point(key, 3));
    }
    crown.write(out);
    out.line("ObjectEnd");
}

InstanceTransform place_of(std::uint64_t tree, const Vec3& origin, double height) {
    const Vec2 turn = on_circle(noise(tree, 2));
    const double size = height * (1 + 0.3 * noise(tree, 3));
    return {size * Vec3(turn.x, 0, -turn.y),
            size * Vec3(0.1 * noise(tree, 4), 1, 0.1 * noise(tree, 5)),
            size * Vec3(turn.y, 0, turn.x), origin};
}

}  // namespace

void forest(LineWriter& out, std::int64_t size) {
    begin_world(out, {0.9, 0.45, 1.1}, {0, 0, 0.15}, 42);
    write_ground(out, 1.05);
    for (std::uint32_t i = 0; i < trees; ++i) write_tree(out, i);
    const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(size))));
    const double spacing = 2 / static_cast<double>(side);
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(size); ++i) {
        const auto along = [&](std::uint64_t cell, std::uint64_t key) {
            return spacing * (static_cast<double>(cell) + 0.5 + 0.35 * noise(i, key)) - 1;
        };
        const Vec3 origin(along(i % side, 0), 0, along(i / side, 1));
        write_instance(out, static_cast<std::uint32_t>(scramble(i) % trees),
                       place_of(i, origin, 1.6 * spacing));
    }
    out.line("WorldEnd");
}

}  // namespace etalon::generate
