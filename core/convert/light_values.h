#pragma once

#include "core/color/srgb.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Converts colours and weights to the light for which they stand. A product of display values is
/// about the display value of the product of the light, so that weights are decoded like colours.
class LightValues {
  public:
    /// `are_displayed`: colours are display values, not light already.
    explicit LightValues(bool are_displayed) : are_displayed_(are_displayed) {}

    Color operator()(const Color& c) const {
        const auto decoded = [](float value) {
            return static_cast<float>(srgb_decoded(std::max(value, 0.0F)));
        };
        return are_displayed_ ? Color(decoded(c.x), decoded(c.y), decoded(c.z)) : c;
    }

  private:
    bool are_displayed_;
};

}  // namespace etalon
