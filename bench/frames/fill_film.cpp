#include "bench/frames/fill_film.h"

#include <algorithm>

#include "app/common/stopwatch.h"

namespace etalon::frames {
namespace {

/// Samples that are added together. The time of making them is not counted.
class Batch {
  public:
    explicit Batch(ImageFilm& film) : film_(film) {}

    void add(const Imath::V2i& pixel, std::uint32_t number, std::uint32_t count) {
        constexpr std::size_t most = 1024;
        const double share = (number + 0.5) / count;
        const auto i = static_cast<std::uint32_t>(places_.size());
        if (runs_.empty() || runs_.back().pixel != pixel) runs_.push_back({pixel, i, i});
        runs_.back().last = i + 1;
        places_.emplace_back(pixel.x + share, pixel.y + share);
        if (places_.size() >= most) flush();
    }

    void flush() {
        std::vector<Color> colors(places_.size(), Color(0.5F));
        Stopwatch watch;
        film_.add(runs_, places_, colors);
        seconds_ += watch.lap().cpu;
        runs_.clear();
        places_.clear();
    }

    double seconds() const { return seconds_; }

  private:
    ImageFilm& film_;
    std::vector<PixelRun> runs_;
    std::vector<Vec2> places_;
    double seconds_ = 0;
};

}  // namespace

double fill_film(ImageFilm& film, const Film& image) {
    const Imath::Box2i &w = film.samples().window(), &inner = image.window();
    Batch batch(film);
    for (int y = w.min.y; y <= w.max.y; ++y) {
        for (int x = w.min.x; x <= w.max.x; ++x) {
            const std::size_t nearest = image.index(std::clamp(x, inner.min.x, inner.max.x),
                                                    std::clamp(y, inner.min.y, inner.max.y));
            const std::uint32_t count = image.counts()[nearest];
            for (std::uint32_t n = 0; n < count; ++n) batch.add({x, y}, n, count);
        }
    }
    batch.flush();
    Stopwatch watch;
    if (film.is_filtered()) film.filtered();
    return batch.seconds() + watch.lap().cpu;
}

}  // namespace etalon::frames
