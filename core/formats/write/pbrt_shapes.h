#pragma once

#include <optional>
#include <string>

#include "core/scene/curve_list.h"
#include "core/scene/revolved.h"

namespace etalon {

/// Statement of a shape of PBRT, and the map that places it. Its numbers are floats, as PBRT reads
/// them; the map's are doubles.
struct PbrtShape {
    Affine to_world;
    std::string statement;
};

/// Returns nothing for a surface that no shape of PBRT can represent.
std::optional<PbrtShape> to_pbrt(const Revolved& surface);

/// Returns the whole curve of which `part` is one of the parts.
PbrtShape to_pbrt(const StoredCurve& part);

}  // namespace etalon
