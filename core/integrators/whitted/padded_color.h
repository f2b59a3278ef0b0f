#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// A colour in a vector of four floats, by which it takes one instruction to calculate with. What
/// the fourth is does not matter.
struct PaddedColor {
    using Floats [[gnu::vector_size(16)]] = float;

    PaddedColor() = default;
    explicit PaddedColor(const Color& c) : floats{c.x, c.y, c.z, 0} {}

    Color color() const { return {floats[0], floats[1], floats[2]}; }

    PaddedColor& operator+=(const PaddedColor& c) {
        floats += c.floats;
        return *this;
    }
    friend PaddedColor operator*(PaddedColor a, const PaddedColor& b) {
        a.floats *= b.floats;
        return a;
    }
    friend PaddedColor operator*(PaddedColor c, float s) {
        c.floats *= s;
        return c;
    }

    Floats floats{};
};

}  // namespace etalon
