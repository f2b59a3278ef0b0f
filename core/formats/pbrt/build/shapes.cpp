// Shapes of a frame, each by one line of a table, and instances of objects.
#include <array>

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
    Entry{"sphere", build_sphere},
    Entry{"disk", build_disk},
    Entry{"cylinder", build_cylinder},
    Entry{"cone", build_cone},
    Entry{"paraboloid", build_paraboloid},
    Entry{"hyperboloid", build_hyperboloid},
};

/// More copies than this would take more memory than most machines have: some 100 bytes each.
constexpr std::size_t most_primitives = 50'000'000;

void build_shape(SceneBuilder& b, const pbrt::Shape& shape, const Affine* instance = nullptr) {
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
    ShapeBuilder s(b, shape, *own, instance);
    entry->build(s);
}

}  // namespace

void build_shapes(SceneBuilder& b) {
    for (const pbrt::Shape& shape : b.frame.shapes) build_shape(b, shape);
    for (const Instance& instance : b.frame.instances) {
        const std::optional<Affine> map = b.affine(instance.to_world.start, instance.where);
        if (!map) continue;
        for (const pbrt::Shape& shape : b.frame.objects[instance.object].shapes) {
            build_shape(b, shape, &*map);
        }
        if (b.geometry().primitives.size() > most_primitives) {
            return b.warn(instance.where, "instances",
                          "instances left out from here on: copies of more than {} primitives",
                          most_primitives);
        }
    }
}

}  // namespace etalon::pbrt
