#include "core/render/renderer.h"

#include <algorithm>
#include <vector>

#include "core/parallel/parallel.h"
#include "core/render/camera_rays.h"
#include "core/render/whitted.h"

namespace etalon {
namespace {

constexpr int tile_size = 16;

/// Names of the camera's sample dimensions; the integrator's are hashes.
enum CameraDimension : std::uint32_t { pixel_dimension = 0, lens_dimension = 1 };

std::vector<Imath::Box2i> tiles_of(const Imath::Box2i& window) {
    std::vector<Imath::Box2i> tiles;
    for (int y = window.min.y; y <= window.max.y; y += tile_size) {
        for (int x = window.min.x; x <= window.max.x; x += tile_size) {
            const Imath::V2i last(std::min(x + tile_size - 1, window.max.x),
                                  std::min(y + tile_size - 1, window.max.y));
            tiles.emplace_back(Imath::V2i(x, y), last);
        }
    }
    return tiles;
}

/// What has rays: pixels, or the corners about them.
Imath::Box2i sampled(Imath::Box2i pixels, bool corners) {
    if (corners) pixels.max += Imath::V2i(1);
    return pixels;
}

class Renderer {
  public:
    Renderer(const Scene& scene, const Intersector& intersector, const EnvironmentMap& environment,
             const RenderOptions& options)
        : options_(options),
          in_pixel_(scene.camera.pixel_rays == PixelRays::centre ? 0.5 : 0.0),
          shares_corners_(options.samples_per_pixel == 0 &&
                          scene.camera.pixel_rays == PixelRays::shared_corners),
          window_(sampled(options.window, shares_corners_)),
          rays_(scene.camera),
          integrator_(scene, intersector, environment, options.samples_per_pixel,
                      options.max_depth),
          tiles_(tiles_of(window_)),
          counts_(tiles_.size()) {}

    Rendering run() {
        Rendering result{Film(window_), {}};
        const int total = std::max(1, options_.samples_per_pixel);
        for (int first = 0, last = 1; first < total;
             first = last, last = std::min(2 * last, total)) {
            render_pass(first, last, total, result.film);
            if (stopped()) break;
            result.samples = last;
        }
        result.complete = result.samples == total;
        if (shares_corners_) result.film = result.film.cells();
        for (const RayCounts& c : counts_) result.counts += c;
        return result;
    }

  private:
    bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

    void render_pass(int first, int last, int total, Film& film) {
        parallel_for(tiles_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (stopped()) return;
                render_tile(i, first, last, film);
                const auto done = samples_done_.fetch_add(last - first) + (last - first);
                report(static_cast<double>(done) /
                       (static_cast<double>(total) * static_cast<double>(tiles_.size())));
            }
        });
    }

    void render_tile(std::size_t tile, int first, int last, Film& film) {
        const Imath::Box2i& box = tiles_[tile];
        for (int y = box.min.y; y <= box.max.y && !stopped(); ++y) {
            for (int x = box.min.x; x <= box.max.x; ++x) {
                for (int s = first; s < last; ++s) film.add(x, y, sample(x, y, s, counts_[tile]));
            }
        }
    }

    Color sample(int x, int y, int index, RayCounts& counts) const {
        const SampleSource source(x, y, options_.seed, static_cast<std::uint32_t>(index));
        const Vec2 corner(x, y);
        if (options_.samples_per_pixel == 0) {
            return integrator_.radiance(rays_.ray(corner + in_pixel_, Vec2(0.5)), source, counts);
        }
        const Vec2 lens = rays_.has_lens() ? source.point(lens_dimension) : Vec2(0.5);
        const Vec2 pixel = corner + source.point(pixel_dimension);
        return integrator_.radiance(rays_.ray(pixel, lens), source, counts);
    }

    void report(double done) const {
        if (options_.progress) options_.progress(done);
    }

    const RenderOptions& options_;
    Vec2 in_pixel_;  ///< where the one ray of a picture without samples goes
    bool shares_corners_;
    Imath::Box2i window_;
    CameraRays rays_;
    Whitted integrator_;
    std::vector<Imath::Box2i> tiles_;
    std::vector<RayCounts> counts_;
    std::atomic<std::int64_t> samples_done_ = 0;
};

}  // namespace

Rendering render(const Scene& scene, const Intersector& intersector,
                 const EnvironmentMap& environment, const RenderOptions& options) {
    return Renderer(scene, intersector, environment, options).run();
}

}  // namespace etalon
