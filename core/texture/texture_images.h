#pragma once

#include <string>
#include <vector>

#include "core/texture/texels.h"

namespace etalon {

/// The images of a scene's textures, each as far as a texture of that type shows it.
struct TextureImages {
    std::vector<Texels> colors, numbers;  ///< as many as the scene has images; some without one
};

/// Reads the images that `textures` show, each file once. Grey stands in for one that cannot be
/// read, as in pbrt-v3; `problems` gets the reasons in the order of the images.
TextureImages read_texture_images(const Textures& textures, std::vector<std::string>& problems);

}  // namespace etalon
