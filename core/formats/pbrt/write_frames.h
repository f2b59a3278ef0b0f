#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Writes frames as PBRT v3 in one order and one spelling, without includes, nested blocks and
/// unused names. Reading it back gives frames of the same content, except for the names of objects
/// and media and the numbers of area lights and transforms. `directory` is where the file will be;
/// paths of files are relative to it. Exceptions of `sink` are passed on.
void write_frames(std::span<const Frame> frames, const std::filesystem::path& directory,
                  const std::function<void(std::string_view)>& sink);

}  // namespace etalon::pbrt
