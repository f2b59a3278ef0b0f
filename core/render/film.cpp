#include "core/render/film.h"

namespace etalon {

Film::Film(const Imath::Box2i& window)
    : window_(window),
      width_(window.max.x - window.min.x + 1),
      pixels_(static_cast<std::size_t>(width_) * (window.max.y - window.min.y + 1)) {}

void Film::add(int x, int y, const Color& sample) {
    Pixel& p = pixels_[static_cast<std::size_t>(y - window_.min.y) * width_ + (x - window_.min.x)];
    p.sum += Vec3(sample);
    ++p.count;
}

std::vector<Color> Film::pixels() const {
    std::vector<Color> result;
    result.reserve(pixels_.size());
    for (const Pixel& p : pixels_) {
        result.emplace_back(p.count == 0 ? Vec3(0) : p.sum / p.count);
    }
    return result;
}

}  // namespace etalon
