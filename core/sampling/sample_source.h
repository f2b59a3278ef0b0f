// The sample points of an image, each identified by its pixel, sample, dimension and seed.
#pragma once

#include "core/sampling/random_sequence.h"
#include "core/sampling/seeded_points.h"
#include "core/sampling/sobol.h"
#include "core/sampling/vertex_points.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// The points of one dimension for all samples of a pixel.
class PointSet {
  public:
    PointSet(Sampler sampler, std::uint32_t seed)
        : sobol_(seed), seed_(seed), is_sobol_(sampler == Sampler::sobol) {}

    Vec2 operator()(std::uint32_t index) const {
        return is_sobol_ ? sobol_(index) : uniform_random(index, seed_);
    }

  private:
    ScrambledSobol sobol_;
    std::uint32_t seed_;
    bool is_sobol_;
};

/// All samples of the pixel (x, y).
class PixelSamples {
  public:
    PixelSamples(int x, int y, std::uint64_t seed, Sampler sampler = Sampler::sobol)
        : pixel_(name_of(x, y, seed)), sampler_(sampler) {}

    /// The same, of a pixel with that name.
    PixelSamples(std::uint32_t name, Sampler sampler) : pixel_(name), sampler_(sampler) {}

    PointSet points(std::uint32_t dimension) const { return {sampler_, seed(dimension)}; }

    /// Returns the seed of the sets of a dimension.
    std::uint32_t seed(std::uint32_t dimension) const { return hash(pixel_, dimension); }

    /// Adds the vertex that ray `name` of sample number `index` hits.
    void add_vertex(std::uint32_t name, std::uint32_t index, VertexNames& to) const {
        to.add(pixel_, name, index);
    }

  private:
    /// Mixes the seed's upper half into the pixel's name last, and only if it is not zero, so that
    /// seeds below 2^32 keep the points that they had when seeds were of 32 bits.
    static std::uint32_t name_of(int x, int y, std::uint64_t seed) {
        const std::uint32_t row =
            hash(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(x));
        const std::uint32_t pixel = hash(row, static_cast<std::uint32_t>(y));
        const auto upper = static_cast<std::uint32_t>(seed >> 32);
        return upper == 0 ? pixel : hash(pixel, upper);
    }

    std::uint32_t pixel_;
    Sampler sampler_;
};

/// One sample of one pixel: a source of points, one for each dimension.
class SampleSource {
  public:
    /// Sample number `index` of the pixel.
    SampleSource(const PixelSamples& pixel, std::uint32_t index) : pixel_(pixel), index_(index) {}

    Vec2 point(std::uint32_t dimension) const { return stratified(dimension, 0, 1); }

    /// Returns point number `k` of `parts`, for dimensions with several points per sample. Over all
    /// samples of the pixel they form one well distributed set.
    Vec2 stratified(std::uint32_t dimension, std::uint32_t k, std::uint32_t parts) const {
        return pixel_.points(dimension)(index_ * parts + k);
    }

    /// Adds that point to those that will be generated together.
    void add_stratified(std::uint32_t dimension, std::uint32_t k, std::uint32_t parts,
                        SeededPoints& to) const {
        to.add(pixel_.seed(dimension), index_ * parts + k);
    }

    /// Adds the vertex that ray `name` of the sample hits.
    void add_vertex(std::uint32_t name, VertexNames& to) const {
        pixel_.add_vertex(name, index_, to);
    }

    /// Adds the choices at the vertex of that name to those that will be generated together.
    void add_vertex(std::uint32_t name, VertexPoints& to) const {
        to.add(pixel_.seed(name), index_);
    }

    /// Returns the numbers of a dimension that needs any number of them.
    RandomSequence sequence(std::uint32_t dimension) const {
        return {pixel_.seed(dimension), index_};
    }

    /// Returns sample number `k` of the `parts` into which this one splits. Over all samples of the
    /// pixel the points of all parts form one well distributed set.
    SampleSource part(std::uint32_t k, std::uint32_t parts) const {
        return {pixel_, index_ * parts + k};
    }

  private:
    PixelSamples pixel_;
    std::uint32_t index_;
};

}  // namespace etalon
