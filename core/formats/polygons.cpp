// Polygons of any number of corners, concave ones too, flat or with corner normals.
#include <cmath>

#include "core/formats/degenerate.h"
#include "core/formats/scene_loader.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// A vector that is of unit length already stays as it is, so that a scene can be written and read
/// again.
Vec3 made_unit_vector(const Vec3& v) {
    return is_of_unit_length(v) ? v : unit_vector(v);
}

/// Where the corners and normals of the polygon being read begin in the scene's arrays.
struct Place {
    std::uint32_t vertex, normal;
};

/// Appends the corners to the scene's vertices (and normals).
void read_corners(SceneLoader& loader, std::size_t count, bool with_normals) {
    Scene& scene = loader.scene;
    for (std::size_t i = 0; i < count && loader.in.ok(); ++i) {
        scene.vertices.push_back(loader.in.vector("corner"));
        if (with_normals) scene.normals.push_back(loader.in.vector("corner normal"));
    }
}

/// Nothing where the corners just read make no polygon.
bool is_visible(SceneLoader& loader, const Place& first) {
    if (!loader.in.ok()) return false;
    const Vec3 normal = area_normal(std::span(loader.scene.vertices).subspan(first.vertex));
    if (is_finite(normal) && normal != Vec3(0)) return true;
    loader.leave_out("it has no area");
    return false;
}

/// Brings the normals to unit length. A zero one leaves the polygon without any.
std::uint32_t usable_normals(SceneLoader& loader, const Place& first) {
    std::vector<Vec3>& normals = loader.scene.normals;
    for (std::size_t i = first.normal; i < normals.size(); ++i) {
        normals[i] = made_unit_vector(normals[i]);
        if (is_finite(normals[i])) continue;
        loader.in.warn("degenerate", "'{}' shaded flat: a corner normal is zero",
                       loader.in.keyword());
        normals.resize(first.normal);
        return no_index;
    }
    return first.normal;
}

void add(SceneLoader& loader, const Place& first, std::uint32_t normals) {
    const std::uint32_t v = first.vertex;
    const auto count = static_cast<std::uint32_t>(loader.scene.vertices.size()) - v;
    if (count == 3) {
        loader.add(Triangle{{v, v + 1, v + 2}, normals}, loader.sides());
    } else {
        loader.add(Polygon{v, count, normals}, loader.sides());
    }
}

void read(SceneLoader& loader, bool with_normals) {
    Reader& in = loader.in;
    Scene& scene = loader.scene;
    const std::size_t offset = in.tokens().offset();
    const std::size_t count = in.count("number of corners", with_normals ? 6 : 3);
    if (!in.ok()) return;
    const Place first{static_cast<std::uint32_t>(scene.vertices.size()),
                      static_cast<std::uint32_t>(scene.normals.size())};
    read_corners(loader, count, with_normals);
    if (in.ok() && count < 3) {
        in.warn_at(offset, "degenerate", "'{}' left out: {} corners, expected at least 3",
                   in.keyword(), count);
    } else if (is_visible(loader, first)) {
        return add(loader, first, with_normals ? usable_normals(loader, first) : no_index);
    }
    scene.vertices.resize(first.vertex);
    scene.normals.resize(first.normal);
}

}  // namespace

void read_polygon(SceneLoader& loader) {
    read(loader, false);
}

void read_patch(SceneLoader& loader) {
    read(loader, true);
}

}  // namespace etalon
