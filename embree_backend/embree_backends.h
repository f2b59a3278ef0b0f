#pragma once

#include <span>
#include <string>

#include "core/intersect/intersector.h"

namespace etalon {

/// Returns embree, embree-user and embree-builtin.
std::span<const Backend> embree_backends();

/// Returns embree-builtin with RTC_SCENE_FLAG_ROBUST, a second baseline for measurements; no
/// program offers it for rendering.
const Backend& embree_builtin_robust();

/// The library that is loaded, which may differ from the header that was compiled.
struct EmbreeLibrary {
    std::string version;           ///< "3.13.5"
    std::string compiled_version;  ///< version of the header
    std::string isa;               ///< instruction set of its devices, such as "avx2"
};

/// Throws as EmbreeDevice does.
EmbreeLibrary embree_library();

}  // namespace etalon
