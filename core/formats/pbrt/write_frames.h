#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Writes frames as PBRT v3 in one order and one spelling, without includes, nested blocks and
/// names that nothing uses. Reading it back gives frames of the same content, but for the names of
/// objects and media, and the numbers of area lights and transforms. `directory` is where the file
/// will be: files are named from there. Lets through what `sink` throws.
void write_frames(std::span<const Frame> frames, const std::filesystem::path& directory,
                  const std::function<void(std::string_view)>& sink);

}  // namespace etalon::pbrt
