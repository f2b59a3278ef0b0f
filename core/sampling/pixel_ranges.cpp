#include "core/sampling/pixel_ranges.h"

#include <algorithm>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/pixel_ranges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/hash-inl.h"

#ifndef ETALON_PIXEL_RANGES_ONCE
#define ETALON_PIXEL_RANGES_ONCE
namespace etalon {

/// Scrambles of sequences, or of the sequence of each point: see ScrambledSobol.
template <class Word>
struct Scrambles {
    Word *orders, *xs, *ys;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE Words load(const std::uint32_t* from) {
    return hn::LoadU(Words::Tag(), from);
}
HWY_INLINE void store(Words words, std::uint32_t* to) {
    hn::StoreU(words.words, Words::Tag(), to);
}

/// Sets the hash of each of the words, with `second` after it.
void hash_all(const std::uint32_t* words, std::uint32_t second, std::size_t count,
              std::uint32_t* to) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(Words::Tag())) {
        store(hashed(load(words + i), second), to + i);
    }
}

/// Names pixels by the steps of PixelSamples.
void name_all(std::uint64_t seed, const std::uint32_t* xs, const std::uint32_t* ys,
              std::size_t count, std::uint32_t* names) {
    const auto lower = static_cast<std::uint32_t>(seed);
    const auto upper = static_cast<std::uint32_t>(seed >> 32);
    for (std::size_t i = 0; i < count; i += hn::Lanes(Words::Tag())) {
        const Words name = hashed(hashed(lower, load(xs + i)), load(ys + i));
        store(upper == 0 ? name : hashed(name, upper), names + i);
    }
}

void make_points(const std::uint32_t* indices, const Scrambles<const std::uint32_t>& scrambles,
                 std::size_t count, Vec2* points) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(Words::Tag())) {
        store_unit_interval(scrambled_point(load(indices + i), load(scrambles.orders + i),
                                            load(scrambles.xs + i), load(scrambles.ys + i)),
                            points + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(hash_all);
HWY_EXPORT(name_all);
HWY_EXPORT(make_points);

namespace {

std::size_t padded(std::size_t count) {
    return (count + sobol_lanes - 1) / sobol_lanes * sobol_lanes;
}

void make_room(std::size_t count, std::initializer_list<std::vector<std::uint32_t>*> columns) {
    for (auto* column : columns) {
        if (column->size() < padded(count)) column->resize(2 * padded(count));
    }
}

}  // namespace

void PixelRanges::name() {
    make_room(runs_.size(), {&xs_, &ys_, &names_});
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        xs_[i] = static_cast<std::uint32_t>(runs_[i].pixel.x);
        ys_[i] = static_cast<std::uint32_t>(runs_[i].pixel.y);
    }
    HWY_DYNAMIC_DISPATCH(name_all)(seed_, xs_.data(), ys_.data(), runs_.size(), names_.data());
}

void PixelRanges::list(std::vector<SampleSource>& sources) const {
    sources.resize(samples(), SampleSource(PixelSamples(0, sampler_), 0));
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const PixelSamples pixel(names_[i], sampler_);
        for (std::uint32_t k = 0; k < runs_[i].size(); ++k) {
            sources[runs_[i].first + k] = SampleSource(pixel, firsts_[i] + k);
        }
    }
}

void PixelRanges::make_points(std::uint32_t dimension, std::vector<Vec2>& points) {
    make_room(runs_.size(), {&seeds_});
    HWY_DYNAMIC_DISPATCH(hash_all)(names_.data(), dimension, runs_.size(), seeds_.data());
    points.resize(padded(samples()));
    sampler_ == Sampler::sobol ? make_sobol_points(points) : make_random_points(points);
    points.resize(samples());
}

void PixelRanges::make_sobol_points(std::vector<Vec2>& points) {
    make_room(runs_.size(), {&orders_, &x_scrambles_, &y_scrambles_});
    std::uint32_t scramble = 0;
    for (Column* column : {&orders_, &x_scrambles_, &y_scrambles_}) {
        HWY_DYNAMIC_DISPATCH(hash_all)
        (seeds_.data(), scramble++, runs_.size(), column->data());
    }
    make_room(samples(), {&sample_indices_, &sample_orders_, &sample_xs_, &sample_ys_});
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const PixelRun& run = runs_[i];
        std::uint32_t index = firsts_[i];
        for (std::uint32_t k = run.first; k < run.last; ++k) {
            sample_indices_[k] = index++;
            sample_orders_[k] = orders_[i];
            sample_xs_[k] = x_scrambles_[i];
            sample_ys_[k] = y_scrambles_[i];
        }
    }
    HWY_DYNAMIC_DISPATCH(make_points)
    (sample_indices_.data(), {sample_orders_.data(), sample_xs_.data(), sample_ys_.data()},
     samples(), points.data());
}

void PixelRanges::make_random_points(std::vector<Vec2>& points) const {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        for (std::uint32_t k = 0; k < runs_[i].size(); ++k) {
            points[runs_[i].first + k] = uniform_random(firsts_[i] + k, seeds_[i]);
        }
    }
}

}  // namespace etalon
#endif
