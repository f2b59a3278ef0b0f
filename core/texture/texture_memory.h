#pragma once

#include <cstddef>

#include "core/scene/texture.h"

namespace etalon {

/// Returns the bytes of memory that the images of textures take once they are read, according to
/// the headers of their files.
std::size_t texture_memory_bytes(const Textures& textures);

}  // namespace etalon
