#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/scene/camera.h"

namespace etalon {

/// Focus of a lens.
struct LensFocus {
    double film_distance;   ///< from the last surface to the film
    double image_distance;  ///< from the principal plane on the film's side to the film
};

/// Returns the position of the film for which objects at `distance` from it are sharp, by the thick
/// lens approximation for rays near the axis. The error says why there is none.
Result<LensFocus> focused(const LensSystem& lens, double distance);

}  // namespace etalon
