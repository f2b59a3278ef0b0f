#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Adds materials to a frame, without duplicates.
class MaterialPool {
  public:
    /// Returns the number of the material in `materials`, which must always be the same vector.
    std::uint32_t add(Material material, std::vector<Material>& materials);

  private:
    std::unordered_multimap<std::size_t, std::uint32_t> numbers_;  ///< by hash
};

}  // namespace etalon::pbrt
