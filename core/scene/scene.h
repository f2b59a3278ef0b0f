// Scene description: plain data, filled by a loader, read by everything else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/environment.h"
#include "core/scene/geometry.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/physical_look.h"

namespace etalon {

/// Materials and lights of the Whitted-style formats. Their light depends neither on the distance
/// from the light nor on the cosine at the light.
struct WhittedLook {
    std::vector<Material> materials;
    std::vector<Light> lights;
    Environment environment;
};

struct Scene {
    std::string format;  ///< "p3f", ...
    Camera camera;
    Geometry geometry;
    std::variant<WhittedLook, PhysicalLook> look;

    /// Returns the look of a scene of a Whitted-style format, which is not is_physical().
    WhittedLook& whitted() { return std::get<WhittedLook>(look); }
    const WhittedLook& whitted() const { return std::get<WhittedLook>(look); }

    bool is_physical() const { return std::holds_alternative<PhysicalLook>(look); }

    /// Returns the look of a scene that is_physical().
    PhysicalLook& physical() { return std::get<PhysicalLook>(look); }
    const PhysicalLook& physical() const { return std::get<PhysicalLook>(look); }
};

/// Returns the bytes held by the scene's arrays.
std::size_t memory_bytes(const Scene& scene);

}  // namespace etalon
