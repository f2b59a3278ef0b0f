#include "core/integrators/integrator.h"

#include <algorithm>

namespace etalon {

void Integrator::emission(const CameraSamples&, std::span<Color> colors) const {
    std::ranges::fill(colors, Color(0.0F));
}

}  // namespace etalon
