// The physical look of a scene: what a path tracer needs to know beside the geometry.
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

/// Data that consecutive primitives of one statement share, beside their shape. A primitive's
/// `material` is the number of its binding.
struct SurfaceBinding {
    std::uint32_t material = 0;      ///< number among the look's materials
    bool flipped = false;            ///< the format's normals are opposite to the shape's
    bool corner_normals = false;     ///< the front is the side of the normals at the corners
    std::uint32_t light = no_index;  ///< number of the light that the primitives are
    /// Offset of the texture coordinates of triangles that have some at their corners: those of
    /// vertex v have the number v - uv_offset in the geometry. Otherwise no_index.
    std::uint32_t uv_offset = no_index;
    NumberSlot alpha{1.0F};         ///< rays pass where it is 0
    NumberSlot shadow_alpha{1.0F};  ///< shadow rays pass where it or `alpha` is 0
    MediumInterface media{};

    /// Returns whether any ray passes the surface anywhere.
    bool is_cut_out() const { return can_be_zero(alpha) || can_be_zero(shadow_alpha); }

  private:
    static bool can_be_zero(const NumberSlot& slot) {
        return slot.texture != no_index || slot.value == 0;
    }
};

/// Source of the name of an image file, for the message if the file cannot be read.
struct NamedImage {
    std::string file;
    std::string where;          ///< FILE:LINE:COLUMN
    std::string_view stand_in;  ///< what is shown instead
};

struct PhysicalLook {
    std::vector<SurfaceBinding> bindings;
    std::vector<PhysicalMaterial> materials;
    std::vector<PhysicalLight> lights;
    std::vector<PhysicalMedium> media;
    std::uint32_t camera_medium = no_index;  ///< medium around the camera
    Textures textures;
    std::vector<NamedImage> named_images;
};

}  // namespace etalon
