#include "app/render/memory.h"

#include <fmt/format.h>

#include "app/common/memory_limit.h"
#include "core/render/image_film.h"

namespace etalon {
namespace {

/// Least memory of a pixel: its part of the film, and its colour.
double bytes_per_pixel(const RenderSettings& settings) {
    return ImageFilm::bytes_per_pixel(settings) + sizeof(Color);
}

}  // namespace

std::string check_memory(const RenderSettings& settings) {
    const Imath::V2i size = settings.window().size() + Imath::V2i(1);
    const double needed = bytes_per_pixel(settings) * size.x * size.y, available = memory_limit();
    if (needed <= available) return {};
    return fmt::format("{} x {} pixels need {}; the program may take {} (--max-memory)", size.x,
                       size.y, bytes_text(needed), bytes_text(available));
}

}  // namespace etalon
