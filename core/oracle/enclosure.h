// Boxes around shapes by which the oracle skips primitives. They are deliberately not those of the
// accelerators, a mistake in which the oracle must not share.
#pragma once

#include <cstdint>

#include "core/scene/geometry.h"

namespace etalon {

/// Returns a box around a primitive up to roundings of its numbers, from the largest lengths in its
/// definition and not as tight as can be. Infinite or not a number if these are; empty if they are
/// those of no shape.
Box3 enclosure(const Geometry& geometry, std::uint32_t primitive);

}  // namespace etalon
