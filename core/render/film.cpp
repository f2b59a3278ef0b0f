#include "core/render/film.h"

namespace etalon {

Film::Film(const Imath::Box2i& window)
    : window_(window),
      width_(window.max.x - window.min.x + 1),
      pixels_(static_cast<std::size_t>(width_) * (window.max.y - window.min.y + 1)) {}

void Film::add(int x, int y, const Color& sample) {
    Pixel& p = at(x, y);
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

Film Film::cells() const {
    Film result({window_.min, window_.max - Imath::V2i(1)});
    for (int y = window_.min.y; y < window_.max.y; ++y) {
        for (int x = window_.min.x; x < window_.max.x; ++x) {
            for (const auto& [dx, dy] : {Imath::V2i(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                result.at(x, y).sum += at(x + dx, y + dy).sum;
                result.at(x, y).count += at(x + dx, y + dy).count;
            }
        }
    }
    return result;
}

}  // namespace etalon
