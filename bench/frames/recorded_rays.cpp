#include "bench/frames/recorded_rays.h"

#include "app/common/stopwatch.h"

namespace etalon::frames {

void RecordedRays::Batches::add(std::span<const Ray> more, std::size_t every) {
    rays += more.size();
    if (batches++ % every != 0) return;
    kept_rays += more.size();
    kept.emplace_back(more.begin(), more.end());
}

double RecordedRays::Batches::of_all(double seconds) const {
    if (kept_rays == 0) return 0;
    return seconds * static_cast<double>(rays) / static_cast<double>(kept_rays);
}

void RecordedRays::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    closest_.add(rays, every_);
    backend_.closest(rays, hits);
}

void RecordedRays::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    occluded_.add(rays, every_);
    backend_.occluded(rays, blocked);
}

double RecordedRays::replay() const {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> blocked;
    Stopwatch watch;
    for (const std::vector<Ray>& rays : closest_.kept) {
        hits.resize(rays.size());
        backend_.closest(rays, hits);
    }
    const double closest = watch.lap().cpu;
    for (const std::vector<Ray>& rays : occluded_.kept) {
        blocked.resize(rays.size());
        backend_.occluded(rays, blocked);
    }
    return closest_.of_all(closest) + occluded_.of_all(watch.lap().cpu);
}

}  // namespace etalon::frames
