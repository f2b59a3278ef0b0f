#include "core/sampling/sobol.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/sobol.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/sobol-inl.h"

#ifndef ETALON_SOBOL_ONCE
#define ETALON_SOBOL_ONCE
namespace etalon {

/// Names of points in SoA layout: `count` of each, a multiple of SobolBatch::lanes.
struct SobolNames {
    const std::uint32_t *index, *order, *x, *y;
    std::size_t count;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void make_points(const SobolNames& names, Vec2* points) {
    const Words::Tag tag;
    for (std::size_t i = 0; i < names.count; i += hn::Lanes(tag)) {
        const auto load = [&](const std::uint32_t* from)
                              HWY_ATTR { return Words(hn::LoadU(tag, from + i)); };
        store_unit_interval(
            scrambled_point(load(names.index), load(names.order), load(names.x), load(names.y)),
            points + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_points);

namespace {

/// Maps to [0, 1); all 32 bits fit a double.
double unit_interval(std::uint32_t x) {
    return x * 0x1p-32;
}

}  // namespace

Vec2 ScrambledSobol::operator()(std::uint32_t index) const {
    const auto [x, y] = HWY_NAMESPACE::scrambled_point(index, order_, x_, y_);
    return {unit_interval(x), unit_interval(y)};
}

void SobolBatch::add(const ScrambledSobol& sequence, std::uint32_t first, std::uint32_t last) {
    const std::size_t begin = size_, count = last - first;
    size_ += count;
    if (size_ > index_.size()) {
        const std::size_t room = (2 * size_ + lanes) / lanes * lanes;
        for (auto* row : {&index_, &order_, &x_, &y_}) row->resize(room);
    }
    for (std::size_t i = 0; i < count; ++i) {
        index_[begin + i] = first + static_cast<std::uint32_t>(i);
        order_[begin + i] = sequence.order_;
        x_[begin + i] = sequence.x_;
        y_[begin + i] = sequence.y_;
    }
}

void SobolBatch::move_to(std::vector<Vec2>& points) {
    const std::size_t first = points.size(), whole = (size_ + lanes - 1) / lanes * lanes;
    points.resize(first + whole);
    HWY_DYNAMIC_DISPATCH(make_points)
    ({index_.data(), order_.data(), x_.data(), y_.data(), whole}, points.data() + first);
    points.resize(first + size_);
    size_ = 0;
}

Vec2 uniform_random(std::uint32_t index, std::uint32_t seed) {
    const std::uint32_t name = hash(seed, index);
    return {unit_interval(hash(name, 0)), unit_interval(hash(name, 1))};
}

}  // namespace etalon
#endif
