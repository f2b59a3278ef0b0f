#pragma once

#include <cstddef>

#include "core/scene/texture.h"

namespace etalon {

/// Returns the bytes that the images of textures take once they are read, by the headers of their
/// files.
std::size_t texture_memory_bytes(const Textures& textures);

}  // namespace etalon
