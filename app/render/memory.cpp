#include "app/render/memory.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/common/memory_limit.h"
#include "app/render/aovs.h"
#include "core/numerics/pixel_window.h"
#include "core/render/image_film.h"

namespace etalon {
namespace {

/// Returns the least memory of a pixel: its part of the film, and its colour or AOVs, which are
/// made before. The film of a part is twice more in memory when it is written: as bytes, and in the
/// file.
double bytes_per_pixel(const RenderArguments& a, const RenderSettings& settings) {
    const double film = ImageFilm::bytes_per_pixel(settings);
    const double image = std::max<double>(sizeof(Color), aov_bytes_per_pixel(a.aovs));
    return (a.part.empty() ? film : 3 * film) + image;
}

}  // namespace

std::string check_memory(const RenderArguments& a, const RenderSettings& settings) {
    const Imath::V2i size = window_size(settings.window());
    const double needed = bytes_per_pixel(a, settings) * size.x * size.y,
                 available = memory_limit();
    if (needed <= available) return {};
    return fmt::format("{} x {} pixels need {}; the program may take {} (--max-memory)", size.x,
                       size.y, bytes_text(needed), bytes_text(available));
}

}  // namespace etalon
