#pragma once

#include <span>
#include <string>

#include "core/intersect/intersector.h"

namespace etalon {

/// embree, embree-user, embree-builtin.
std::span<const Backend> embree_backends();

/// embree-builtin with RTC_SCENE_FLAG_ROBUST, a second baseline for measurements; no program
/// offers it to render with.
const Backend& embree_builtin_robust();

/// The library that is loaded, which need not be the one whose header was compiled.
struct EmbreeLibrary {
    std::string version;           ///< "3.13.5"
    std::string compiled_version;  ///< of the header
    std::string isa;               ///< that its devices are made for, "avx2"
};

/// Throws as EmbreeDevice does.
EmbreeLibrary embree_library();

}  // namespace etalon
