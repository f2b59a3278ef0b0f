// What a scene is: plain data, filled by a loader, read by everything else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/environment.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/shapes.h"

namespace etalon {

/// Which side of a surface can be hit. The front of a closed shape is its outside.
enum class Sides : std::uint8_t { both, front, back };

/// The primitives of a scene are numbered in order of appearance; where two are hit at the same
/// distance the lower number wins, in every backend.
struct Primitive {
    ShapeKind kind;
    Sides sides;
    std::uint32_t index;     ///< into the array of its kind
    std::uint32_t material;  ///< into Scene::materials
};

struct Scene {
    std::string format;  ///< "p3f", ...
    Camera camera;
    Environment environment;
    std::vector<Light> lights;
    std::vector<Material> materials;

    std::vector<Primitive> primitives;
    ShapeArrays shapes;
    std::vector<Vec3> vertices, normals;

    template <class Shape>
    std::vector<Shape>& all() {
        return std::get<std::vector<Shape>>(shapes);
    }
    template <class Shape>
    const std::vector<Shape>& all() const {
        return std::get<std::vector<Shape>>(shapes);
    }

    /// The data of a primitive known to be a `Shape`.
    template <class Shape>
    const Shape& get(const Primitive& p) const {
        return all<Shape>()[p.index];
    }

    template <class Shape>
    void add(const Shape& shape, std::uint32_t material, Sides sides = Sides::both) {
        const auto index = static_cast<std::uint32_t>(all<Shape>().size());
        all<Shape>().push_back(shape);
        primitives.push_back({kind_of<Shape>(), sides, index, material});
    }
};

/// Bytes held by the scene's arrays.
std::size_t memory_bytes(const Scene& scene);

}  // namespace etalon
