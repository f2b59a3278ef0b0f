#pragma once

#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Sums of samples, pixel by pixel, over a window of the picture. Threads may add to different
/// pixels at the same time.
class Film {
  public:
    /// `window` inclusive on both ends.
    explicit Film(const Imath::Box2i& window);

    void add(int x, int y, const Color& sample);

    const Imath::Box2i& window() const { return window_; }

    /// The mean of each pixel's samples, rows from the top; black where there is none yet.
    std::vector<Color> pixels() const;

  private:
    struct Pixel {
        Vec3 sum{0};
        std::uint32_t count = 0;
    };

    Imath::Box2i window_;
    int width_;
    std::vector<Pixel> pixels_;
};

}  // namespace etalon
