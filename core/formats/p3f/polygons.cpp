// p and pp: polygons of any number of corners, concave ones too, flat or with corner normals.
#include <cmath>

#include "core/formats/p3f/degenerate.h"
#include "core/formats/p3f/loader.h"

namespace etalon::p3f {
namespace {

Vec3 normalized(const Vec3& v) {
    const Vec3 n = to_unit_magnitude(v);
    return n / std::sqrt(n.dot(n));
}

/// Where the corners and normals of the polygon being read begin in the scene's arrays.
struct Place {
    std::uint32_t vertex, normal;
};

/// Appends the corners to the scene's vertices (and normals).
void read_corners(Loader& loader, std::size_t count, bool with_normals) {
    Scene& scene = loader.scene;
    for (std::size_t i = 0; i < count && loader.in.ok(); ++i) {
        scene.vertices.push_back(loader.in.vector("corner"));
        if (with_normals) scene.normals.push_back(loader.in.vector("corner normal"));
    }
}

/// Nothing where the corners just read make no polygon.
bool is_visible(Loader& loader, const Place& first) {
    if (!loader.in.ok()) return false;
    const Vec3 normal = area_normal(std::span(loader.scene.vertices).subspan(first.vertex));
    if (is_finite(normal) && normal != Vec3(0)) return true;
    loader.in.warn("degenerate", "'{}' left out: it has no area", loader.in.keyword());
    return false;
}

/// Brings the normals to unit length. A zero one leaves the polygon without any.
std::uint32_t usable_normals(Loader& loader, const Place& first) {
    std::vector<Vec3>& normals = loader.scene.normals;
    for (std::size_t i = first.normal; i < normals.size(); ++i) {
        normals[i] = normalized(normals[i]);
        if (is_finite(normals[i])) continue;
        loader.in.warn("degenerate", "'pp' shaded flat: a corner normal is zero");
        normals.resize(first.normal);
        return no_index;
    }
    return first.normal;
}

void add(Loader& loader, const Place& first, std::uint32_t normals) {
    const std::uint32_t material = loader.current_material();
    const std::uint32_t v = first.vertex;
    const auto count = static_cast<std::uint32_t>(loader.scene.vertices.size()) - v;
    if (count == 3) {
        loader.scene.add(Triangle{{v, v + 1, v + 2}, normals}, material, loader.sides());
    } else {
        loader.scene.add(Polygon{v, count, normals}, material, loader.sides());
    }
}

void read(Loader& loader, bool with_normals) {
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

void read_polygon(Loader& loader) {
    read(loader, false);
}

void read_patch(Loader& loader) {
    read(loader, true);
}

}  // namespace etalon::p3f
