#include "bench/speed/tracing.h"

#include <algorithm>
#include <atomic>

#include "bench/speed/pinned.h"

namespace etalon::speed {
namespace {

constexpr std::size_t portion = 256;  ///< rays that a thread takes at a time

void answer(const Intersector& intersector, std::span<const Ray> rays, std::span<Answer> answers) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        answers[i] = intersector.closest(rays[i]).value_or(missed);
    }
}

void answer_occlusion(const Intersector& intersector, std::span<const Ray> rays,
                      std::span<Answer> answers) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        answers[i] = intersector.occluded(rays[i]) ? Answer{0, 0} : missed;
    }
}

}  // namespace

Duration trace(const Intersector& intersector, const RaySet& set, int threads,
               std::span<Answer> answers) {
    const std::span rays(set.rays);
    std::atomic<std::size_t> taken{0};
    return run_pinned(threads, [&] {
        for (;;) {
            const std::size_t first = taken.fetch_add(portion);
            if (first >= rays.size()) return;
            const std::size_t count = std::min(portion, rays.size() - first);
            const auto to_do = rays.subspan(first, count);
            const auto place = answers.subspan(first, count);
            (set.occlusion ? answer_occlusion : answer)(intersector, to_do, place);
        }
    });
}

}  // namespace etalon::speed
