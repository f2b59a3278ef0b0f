// A tree that forks in two, after Aono & Kunii 1984, "Botanical Tree Image Generation": each branch
// is a cone with a sphere for its joint; its two children lean away to either side, the plane of
// the fork turned by the golden angle from one fork to the next.
#include "scenes/generate/arithmetic.h"
#include "scenes/generate/generator_families.h"

namespace etalon::generate {
namespace {

struct Branch {
    Vec3 base, along, side;  ///< `along` and `side` are unit vectors, one across the other
    double length, radius;

    Vec3 tip() const { return base + length * along; }
};

constexpr double child_length = 0.8;
const double child_radius = std::sqrt(0.5);  // the cross-sections add up (Leonardo's rule)

Branch child(const Branch& parent, double lean_in_turns) {
    const Vec2 turn = on_circle(0.381966);
    const Vec3 side = turn.x * parent.side + turn.y * (parent.along % parent.side);
    const Vec2 lean = on_circle(lean_in_turns);
    return {.base = parent.tip(),
            .along = (lean.x * parent.along + lean.y * side).normalized(),
            .side = (lean.x * side - lean.y * parent.along).normalized(),
            .length = parent.length * child_length,
            .radius = parent.radius * child_radius};
}

/// Calls visit(branch, forks still to come) for the branch and all that grows from it.
template <class Visit>
void grow(const Branch& branch, std::int64_t forks, const Visit& visit) {
    visit(branch, forks);
    if (forks == 0) return;
    grow(child(branch, 0.07), forks - 1, visit);
    grow(child(branch, -0.11), forks - 1, visit);
}

}  // namespace

void tree(Writer& out, std::int64_t size) {
    out.background({0.55F, 0.72F, 0.92F});
    out.camera({{1.5, 1.7, 6.2}, {0, 1.6, 0}, {0, 1, 0}, 38}, {512, 512});
    out.light({6, 8, 5}, {0.75F, 0.7F, 0.6F});
    out.light({-6, 7, 4}, {0.3F, 0.33F, 0.38F});
    ground(out);
    const Branch trunk{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 0.75, 0.13};

    // Two passes, so that the material changes once and not at every leaf.
    out.material({.diffuse = {0.45F, 0.33F, 0.22F}, .kd = 0.9});
    grow(trunk, size, [&](const Branch& b, std::int64_t forks) {
        const double tip_radius = b.radius * child_radius;
        out.cone(b.base, b.radius, b.tip(), tip_radius);
        if (forks > 0) out.sphere(b.tip(), tip_radius);
    });
    out.material({.diffuse = {0.35F, 0.6F, 0.2F}, .kd = 0.9});
    grow(trunk, size, [&](const Branch& b, std::int64_t forks) {
        if (forks == 0) out.sphere(b.tip(), 6 * b.radius);
    });
}

}  // namespace etalon::generate
