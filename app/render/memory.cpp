#include "app/render/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <algorithm>

#include "core/render/image_film.h"

namespace etalon {
namespace {

/// Least memory of a pixel: its part of the film while it is rendered, and its colour.
double bytes_per_pixel(const RenderSettings& settings) {
    return ImageFilm::bytes_per_pixel(settings) + sizeof(Color);
}

/// Returns the bytes that the process can have: memory and swap, or the limit set for it.
double available_bytes() {
    struct sysinfo info = {};
    if (sysinfo(&info) != 0) return infinity;
    const double machine =
        (static_cast<double>(info.totalram) + static_cast<double>(info.totalswap)) * info.mem_unit;
    rlimit limit = {};
    const bool is_limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return is_limited ? std::min(machine, static_cast<double>(limit.rlim_cur)) : machine;
}

}  // namespace

std::string check_memory(const RenderSettings& settings) {
    const Imath::V2i size = settings.window().size() + Imath::V2i(1);
    const double needed = bytes_per_pixel(settings) * size.x * size.y,
                 available = available_bytes();
    if (needed <= available) return {};
    return fmt::format("{} x {} pixels need {:.1f} GB; there are {:.1f}", size.x, size.y,
                       1e-9 * needed, 1e-9 * available);
}

}  // namespace etalon
