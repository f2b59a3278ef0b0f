// Shapes of a frame, each by one line of a table, and instances of objects.
#include <array>
#include <utility>

#include "core/formats/pbrt/build/shape_builder.h"

namespace etalon::pbrt {
namespace {

struct Entry {
    std::string_view name;
    void (*build)(ShapeBuilder&);
};

// To add a shape: a function in the fitting file of this folder, declared in shape_builder.h, and a
// line here.
constexpr std::array entries = {
    Entry{"trianglemesh", build_triangle_mesh},
    Entry{"plymesh", build_ply_mesh},
    Entry{"loopsubdiv", build_loop_subdivision},
    Entry{"heightfield", build_heightfield},
    Entry{"nurbs", build_nurbs},
    Entry{"sphere", build_sphere},
    Entry{"disk", build_disk},
    Entry{"cylinder", build_cylinder},
    Entry{"cone", build_cone},
    Entry{"paraboloid", build_paraboloid},
    Entry{"hyperboloid", build_hyperboloid},
    Entry{"curve", build_curve},
};

/// Builds a shape into the builder's geometry.
void build_shape(SceneBuilder& b, const pbrt::Shape& shape) {
    const auto* const entry = std::ranges::find(entries, shape.plugin.type->name, &Entry::name);
    if (entry == entries.end()) {
        b.warn(shape.plugin.where, "stand-in", "shape \"{}\" is not rendered yet; it is left out",
               shape.plugin.type->name);
        return;
    }
    const std::optional<Affine> own = b.affine(shape.to_world.start, shape.plugin.where);
    if (!own) return;
    if (shape.to_world.is_animated()) {
        b.warn(shape.plugin.where, "motion",
               "motion is not rendered yet; \"{}\" stands where it "
               "is at first",
               shape.plugin.type->name);
    }
    ShapeBuilder s(b, shape, *own);
    entry->build(s);
}

/// Builds what instances are made of. Returns its number.
std::uint32_t build_object(SceneBuilder& b, const Object& object) {
    std::vector<Geometry>& objects = b.scene().geometry.objects;
    Geometry around = std::exchange(b.scene().geometry, {});
    for (const pbrt::Shape& shape : object.shapes) build_shape(b, shape);
    std::swap(around, b.scene().geometry);
    shrink_to_fit(around);
    objects.push_back(std::move(around));
    return static_cast<std::uint32_t>(objects.size() - 1);
}

void build_instances(SceneBuilder& b) {
    std::vector<std::uint32_t> numbers(b.frame.objects.size(), none);
    b.scene().geometry.instances.reserve(b.frame.instances.size());
    for (const pbrt::Instance& instance : b.frame.instances) {
        const std::optional<Affine> map = b.affine(instance.to_world.start, instance.where);
        if (!map) continue;
        std::uint32_t& number = numbers[instance.object];
        if (number == none) number = build_object(b, b.frame.objects[instance.object]);
        b.scene().geometry.instances.emplace_back(*map, number);
    }
}

}  // namespace

void build_shapes(SceneBuilder& b) {
    for (const pbrt::Shape& shape : b.frame.shapes) build_shape(b, shape);
    build_instances(b);
}

}  // namespace etalon::pbrt
