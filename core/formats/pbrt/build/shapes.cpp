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

/// Builds a shape into the builder's geometry with its map.
void build_shape(SceneBuilder& b, const pbrt::Shape& shape, const Affine& map) {
    const auto* const entry = std::ranges::find(entries, shape.plugin.type->name, &Entry::name);
    ShapeBuilder s(b, shape, map);
    entry->build(s);
}

/// Returns whether a shape can be built; warns if not.
bool is_rendered(SceneBuilder& b, const pbrt::Shape& shape) {
    const std::string_view name = shape.plugin.type->name;
    if (std::ranges::find(entries, name, &Entry::name) != entries.end()) return true;
    b.warn(shape.plugin.where, "stand-in", "shape \"{}\" is not rendered yet; it is left out",
           name);
    return false;
}

/// Builds the geometry of instances by calling `build`. Returns its number.
template <class Build>
std::uint32_t build_object(SceneBuilder& b, const Build& build) {
    std::vector<Geometry>& objects = b.geometry().objects;
    Geometry around = std::exchange(b.geometry(), {});
    build();
    std::swap(around, b.geometry());
    shrink_to_fit(around);
    objects.push_back(std::move(around));
    return static_cast<std::uint32_t>(objects.size() - 1);
}

void add_instance(SceneBuilder& b, const PlaceInTime& place, std::uint32_t object) {
    if (place.motion) {
        b.geometry().add_moving_instance(*place.motion, object);
        b.scene().camera.sees_motion = true;
    } else {
        b.geometry().instances.emplace_back(place.at_open, object);
    }
}

/// Builds a shape of the world. A moving shape is the only instance of an object.
void build_in_world(SceneBuilder& b, const pbrt::Shape& shape) {
    if (!is_rendered(b, shape)) return;
    const auto place = b.place_in_time(shape.to_world, shape.plugin.where);
    if (!place) return;
    if (!place->motion) return build_shape(b, shape, place->at_open);
    add_instance(b, *place, build_object(b, [&] { build_shape(b, shape, Affine{}); }));
}

void build_in_object(SceneBuilder& b, const pbrt::Shape& shape) {
    if (!is_rendered(b, shape)) return;
    const auto place = b.place_in_time(shape.to_world, shape.plugin.where);
    if (!place) return;
    if (place->motion) {
        b.warn(shape.plugin.where, "motion",
               "motion within an object is not rendered yet; \"{}\" stands where it is when the "
               "shutter opens",
               shape.plugin.type->name);
    }
    build_shape(b, shape, place->at_open);
}

void build_instances(SceneBuilder& b) {
    std::vector<std::uint32_t> numbers(b.frame.objects.size(), none);
    b.geometry().instances.reserve(b.geometry().instances.size() + b.frame.instances.size());
    for (const pbrt::Instance& instance : b.frame.instances) {
        const auto place = b.place_in_time(instance.to_world, instance.where);
        if (!place) continue;
        std::uint32_t& number = numbers[instance.object];
        if (number == none) {
            number = build_object(b, [&] {
                for (const auto& shape : b.frame.objects[instance.object].shapes) {
                    build_in_object(b, shape);
                }
            });
        }
        add_instance(b, *place, number);
    }
}

}  // namespace

void build_shapes(SceneBuilder& b) {
    for (const pbrt::Shape& shape : b.frame.shapes) build_in_world(b, shape);
    build_instances(b);
}

}  // namespace etalon::pbrt
