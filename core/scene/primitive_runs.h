// Primitives by statements: data that neighbouring primitives share is stored once.
#pragma once

#include <cstdint>
#include <span>

#include "core/parallel/large_pages.h"
#include "core/scene/shapes.h"
#include "core/scene/value_iterator.h"

namespace etalon {

/// Sides of a surface that can be hit. The front of a closed shape is its outside.
enum class Sides : std::uint8_t {
    both,
    front,
    back,
    cut_out  ///< both, except in holes; only for triangles: see core/intersect/cut_outs.h
};

/// Everything about one primitive beside its shape's own data.
struct Primitive {
    ShapeKind kind;
    Sides sides;
    std::uint32_t index;     ///< in the array of its kind
    std::uint32_t material;  ///< number in the scene's look
    /// Offset of the normals of a triangle that has some at its corners: that of vertex v has the
    /// number v - normal_offset. Otherwise no_index.
    std::uint32_t normal_offset = no_index;
};

/// Consecutive primitives that differ only in their index, which counts up.
struct Run {
    std::uint32_t first;  ///< number of the first primitive
    Primitive start;      ///< the first primitive
};

/// All primitives of a scene, in order of appearance.
class PrimitiveRuns {
  public:
    PrimitiveRuns() = default;
    explicit PrimitiveRuns(std::span<const Primitive> primitives) {
        for (const Primitive& p : primitives) push_back(p);
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    void push_back(const Primitive& primitive) {
        if (runs_.empty() || !continues(runs_.back(), primitive)) {
            runs_.push_back({static_cast<std::uint32_t>(size_), primitive});
        }
        index(primitive, static_cast<std::uint32_t>(runs_.size()) - 1);
        ++size_;
    }

    /// Returns a primitive without a search, as this is done for every hit.
    Primitive operator[](std::size_t primitive) const {
        const std::uint32_t entry = of_strides_[primitive / stride];
        if ((entry & is_run) == 0) return listed_[entry + primitive % stride];
        return in_run(entry & ~is_run, primitive);
    }

    Primitive front() const { return (*this)[0]; }

    /// Returns all primitives, one by one.
    std::vector<Primitive> list() const {
        std::vector<Primitive> all;
        for (const Primitive p : *this) all.push_back(p);
        return all;
    }

    ValueIterator<PrimitiveRuns> begin() const { return {*this, 0}; }
    ValueIterator<PrimitiveRuns> end() const { return {*this, size_}; }

    void shrink_to_fit() {
        runs_.shrink_to_fit();
        of_strides_.shrink_to_fit();
        listed_.shrink_to_fit();
    }

    std::size_t memory_bytes() const {
        return runs_.capacity() * sizeof(Run) + of_strides_.capacity() * sizeof(std::uint32_t) +
               listed_.capacity() * sizeof(Primitive);
    }

  private:
    static constexpr std::size_t stride = 64;
    static constexpr std::uint32_t is_run = 0x80000000U;

    bool continues(const Run& run, const Primitive& p) const {
        const Primitive& start = run.start;
        return p.kind == start.kind && p.sides == start.sides && p.material == start.material &&
               p.normal_offset == start.normal_offset && p.index - start.index == size_ - run.first;
    }

    Primitive in_run(std::uint32_t run, std::size_t primitive) const {
        const auto& [first, start] = runs_[run];
        Primitive p = start;
        p.index += static_cast<std::uint32_t>(primitive) - first;
        return p;
    }

    /// Records where the next primitive is found, which belongs to the last run.
    void index(const Primitive& primitive, std::uint32_t run) {
        const std::size_t place = size_ % stride;
        if (place == 0) of_strides_.push_back(is_run | run);
        std::uint32_t& entry = of_strides_.back();
        if ((entry & is_run) != 0 && entry != (is_run | run)) {
            entry = list_stride(entry & ~is_run, place);
        }
        if ((entry & is_run) == 0) listed_[entry + place] = primitive;
    }

    /// Stores one by one the `count` primitives of the last stride, all of which are in `run`.
    /// Returns the index of the first.
    std::uint32_t list_stride(std::uint32_t run, std::size_t count) {
        const std::size_t first = listed_.size();
        listed_.resize(first + stride);
        for (std::size_t i = 0; i < count; ++i) listed_[first + i] = in_run(run, size_ - count + i);
        return static_cast<std::uint32_t>(first);
    }

    LargeVector<Run> runs_;
    /// For each stride of 64 primitives: is_run and the number of the run of all, or the index of
    /// the first in listed_.
    LargeVector<std::uint32_t> of_strides_;
    LargeVector<Primitive> listed_;  ///< primitives of the strides with several runs
    std::size_t size_ = 0;
};

}  // namespace etalon
