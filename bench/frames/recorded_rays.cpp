#include "bench/frames/recorded_rays.h"

#include "app/common/stopwatch.h"

namespace etalon::frames {
namespace {

/// Traces all batches, one after another.
template <class Batches, class Answer, class Ask>
void ask_again(const Batches& batches, std::vector<Answer>& answers, const Ask& ask) {
    for (const std::vector<Ray>& rays : batches.kept) {
        answers.resize(rays.size());
        ask(std::span<const Ray>(rays), std::span(answers));
    }
    for (const auto& kept : batches.kept_streams) {
        const RayStream rays = kept.view();
        answers.resize(rays.size());
        ask(rays, std::span(answers));
    }
}

}  // namespace

RecordedRays::KeptStream::KeptStream(const RayStream& rays) : like_(rays) {
    rays_.make_room(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) rays_.set(i, rays[i]);
    if (rays.times != nullptr) times_.assign(rays.times, rays.times + rays.size());
}

RayStream RecordedRays::KeptStream::view() const {
    RayStream rays = rays_.view(like_.size());
    rays.tmax = like_.tmax;
    rays.traits = like_.traits;
    if (!times_.empty()) rays.times = times_.data();
    return rays;
}

/// Counts a batch of so many rays. Returns whether to record it.
bool RecordedRays::Batches::is_kept(std::size_t more, std::size_t every) {
    rays += more;
    if (batches++ % every != 0) return false;
    kept_rays += more;
    return true;
}

void RecordedRays::Batches::add(std::span<const Ray> more, std::size_t every) {
    if (is_kept(more.size(), every)) kept.emplace_back(more.begin(), more.end());
}

void RecordedRays::Batches::add(const RayStream& more, std::size_t every) {
    if (is_kept(more.size(), every)) kept_streams.emplace_back(more);
}

double RecordedRays::Batches::of_all(double seconds) const {
    if (kept_rays == 0) return 0;
    return seconds * static_cast<double>(rays) / static_cast<double>(kept_rays);
}

void RecordedRays::closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    closest_.add(rays, every_);
    backend_.closest(rays, hits);
}

void RecordedRays::closest(const RayStream& rays, std::span<Hit> hits) const {
    closest_.add(rays, every_);
    backend_.closest(rays, hits);
}

void RecordedRays::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
    occluded_.add(rays, every_);
    backend_.occluded(rays, blocked);
}

void RecordedRays::occluded(const RayStream& rays, std::span<std::uint8_t> blocked) const {
    occluded_.add(rays, every_);
    backend_.occluded(rays, blocked);
}

double RecordedRays::replay() const {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> blocked;
    Stopwatch watch;
    ask_again(closest_, hits, [&](auto rays, auto to) { backend_.closest(rays, to); });
    const double closest = watch.lap().cpu;
    ask_again(occluded_, blocked, [&](auto rays, auto to) { backend_.occluded(rays, to); });
    return closest_.of_all(closest) + occluded_.of_all(watch.lap().cpu);
}

}  // namespace etalon::frames
