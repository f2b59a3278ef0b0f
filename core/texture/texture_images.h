#pragma once

#include <string>
#include <vector>

#include "core/texture/texels.h"

namespace etalon {

/// The images of a scene's textures, for textures of each type that use them.
struct TextureImages {
    std::vector<Texels> colors, numbers;  ///< one for each image of the scene; empty if not used
};

/// Reads the images that `textures` use, each file once. Grey replaces images that cannot be read,
/// as in pbrt-v3; `problems` gets the reasons in the order of the images.
TextureImages read_texture_images(const Textures& textures, std::vector<std::string>& problems);

}  // namespace etalon
