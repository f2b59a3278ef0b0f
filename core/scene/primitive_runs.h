// Primitives by statements: what neighbours have in common is stored once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/shapes.h"
#include "core/scene/value_iterator.h"

namespace etalon {

/// Sides of a surface that can be hit. The front of a closed shape is its outside.
enum class Sides : std::uint8_t { both, front, back };

/// One primitive: what there is to know of it beside its shape's own data.
struct Primitive {
    ShapeKind kind;
    Sides sides;
    std::uint32_t index;     ///< into the array of its kind
    std::uint32_t material;  ///< number in the scene's look
    /// Offset of the normals of a triangle that has some at its corners: that of vertex v is number
    /// v - normal_offset. Else no_index.
    std::uint32_t normal_offset = no_index;
};

/// Consecutive primitives that differ in their index alone, which counts up.
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
        if (size_++ % stride == 0)
            of_strides_.push_back(static_cast<std::uint32_t>(runs_.size()) - 1);
    }

    Primitive operator[](std::size_t primitive) const {
        const Run& run = runs_[run_of(primitive)];
        Primitive p = run.start;
        p.index += static_cast<std::uint32_t>(primitive) - run.first;
        return p;
    }

    Primitive front() const { return (*this)[0]; }

    /// Lists all primitives, one by one.
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
    }

    std::size_t memory_bytes() const {
        return runs_.capacity() * sizeof(Run) + of_strides_.capacity() * sizeof(std::uint32_t);
    }

  private:
    static constexpr std::size_t stride = 64;

    bool continues(const Run& run, const Primitive& p) const {
        const Primitive& start = run.start;
        return p.kind == start.kind && p.sides == start.sides && p.material == start.material &&
               p.normal_offset == start.normal_offset && p.index - start.index == size_ - run.first;
    }

    /// Number of the run that a primitive belongs to: between those of the first primitives of its
    /// stride and of the next one.
    std::size_t run_of(std::size_t primitive) const {
        const std::size_t place = primitive / stride;
        std::size_t low = of_strides_[place];
        std::size_t high =
            place + 1 < of_strides_.size() ? of_strides_[place + 1] : runs_.size() - 1;
        while (low < high) {
            const std::size_t middle = (low + high + 1) / 2;
            if (runs_[middle].first <= primitive) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    std::vector<Run> runs_;
    std::vector<std::uint32_t> of_strides_;  ///< run of every 64th primitive
    std::size_t size_ = 0;
};

}  // namespace etalon
