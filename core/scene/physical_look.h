// How a scene looks by physical rules: what a path tracer needs to know beside the geometry.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/parallel/large_pages.h"
#include "core/scene/physical_light.h"
#include "core/scene/physical_material.h"
#include "core/scene/physical_medium.h"
#include "core/scene/texture.h"

namespace etalon {

/// What consecutive primitives of one statement have in common beside their shape. A primitive's
/// `material` is the number of its binding.
struct SurfaceBinding {
    std::uint32_t material = 0;      ///< number among the look's materials
    bool flipped = false;            ///< the format's normals are opposite to the shape's
    bool corner_normals = false;     ///< the front is the side of the normals at the corners
    std::uint32_t light = no_index;  ///< number of the light that the first primitive is
    std::uint32_t first = 0;         ///< number of the first primitive, where they are lights
    /// Offset of the coordinates of triangles that have some at their corners: those of vertex v
    /// are number v - uv_offset of the geometry's. Else no_index.
    std::uint32_t uv_offset = no_index;
    NumberSlot alpha{1.0F};         ///< a ray passes where it is 0
    NumberSlot shadow_alpha{1.0F};  ///< a shadow ray passes where it, or alpha, is 0
    MediumInterface media{};

    /// Returns whether any ray passes the surface anywhere.
    bool is_cut_out() const { return can_be_zero(alpha) || can_be_zero(shadow_alpha); }

  private:
    static bool can_be_zero(const NumberSlot& slot) {
        return slot.texture != no_index || slot.value == 0;
    }
};

/// The statement that names an image file, for the message if the file cannot be read.
struct NamedImage {
    std::string file;
    std::string where;          ///< FILE:LINE:COLUMN
    std::string_view stand_in;  ///< what is shown then
};

struct PhysicalLook {
    std::vector<SurfaceBinding> bindings;
    std::vector<PhysicalMaterial> materials;
    std::vector<PhysicalLight> lights;
    std::vector<PhysicalMedium> media;
    std::uint32_t camera_medium = no_index;  ///< in which the camera is
    Textures textures;
    std::vector<NamedImage> named_images;
};

}  // namespace etalon
