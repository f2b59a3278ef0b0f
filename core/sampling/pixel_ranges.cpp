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

void PixelRanges::add(int x, int y, std::uint32_t first, std::uint32_t last) {
    if (count_ == xs_.size()) make_room(count_ + 1, {&xs_, &ys_, &firsts_, &lasts_});
    xs_[count_] = static_cast<std::uint32_t>(x);
    ys_[count_] = static_cast<std::uint32_t>(y);
    firsts_[count_] = first;
    lasts_[count_] = last;
    ++count_;
    samples_ += last - first;
}

void PixelRanges::name() {
    make_room(count_, {&names_});
    HWY_DYNAMIC_DISPATCH(name_all)(seed_, xs_.data(), ys_.data(), count_, names_.data());
}

void PixelRanges::list_pixels(std::vector<Imath::V2i>& pixels) const {
    pixels.resize(samples_);
    auto next = pixels.begin();
    for (std::size_t range = 0; range < count_; ++range) {
        const Imath::V2i pixel(static_cast<int>(xs_[range]), static_cast<int>(ys_[range]));
        next = std::fill_n(next, lasts_[range] - firsts_[range], pixel);
    }
}

void PixelRanges::list_sources(std::vector<SampleSource>& sources) const {
    sources.resize(samples_, SampleSource(PixelSamples(0, sampler_), 0));
    auto next = sources.begin();
    for (std::size_t range = 0; range < count_; ++range) {
        const PixelSamples samples(names_[range], sampler_);
        for (std::uint32_t i = firsts_[range]; i < lasts_[range]; ++i) {
            *next++ = SampleSource(samples, i);
        }
    }
}

void PixelRanges::make_points(std::uint32_t dimension, std::vector<Vec2>& points) {
    make_room(count_, {&seeds_});
    HWY_DYNAMIC_DISPATCH(hash_all)(names_.data(), dimension, count_, seeds_.data());
    sampler_ == Sampler::sobol ? make_sobol_points(points) : make_random_points(points);
}

void PixelRanges::make_sobol_points(std::vector<Vec2>& points) {
    make_room(count_, {&orders_, &x_scrambles_, &y_scrambles_});
    std::uint32_t scramble = 0;
    for (Column* column : {&orders_, &x_scrambles_, &y_scrambles_}) {
        HWY_DYNAMIC_DISPATCH(hash_all)(seeds_.data(), scramble++, count_, column->data());
    }
    make_room(samples_, {&sample_indices_, &sample_orders_, &sample_xs_, &sample_ys_});
    std::size_t at = 0;
    for (std::size_t range = 0; range < count_; ++range) {
        for (std::uint32_t i = firsts_[range]; i < lasts_[range]; ++i, ++at) {
            sample_indices_[at] = i;
            sample_orders_[at] = orders_[range];
            sample_xs_[at] = x_scrambles_[range];
            sample_ys_[at] = y_scrambles_[range];
        }
    }
    points.resize(padded(samples_));
    HWY_DYNAMIC_DISPATCH(make_points)
    (sample_indices_.data(), {sample_orders_.data(), sample_xs_.data(), sample_ys_.data()},
     samples_, points.data());
    points.resize(samples_);
}

void PixelRanges::make_random_points(std::vector<Vec2>& points) const {
    points.clear();
    for (std::size_t range = 0; range < count_; ++range) {
        for (std::uint32_t i = firsts_[range]; i < lasts_[range]; ++i) {
            points.push_back(uniform_random(i, seeds_[range]));
        }
    }
}

}  // namespace etalon
#endif
