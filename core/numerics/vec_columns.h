#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// Padding of columns, which vector instructions may read and write: the most lanes that any
/// instruction set has.
inline constexpr std::size_t padded_doubles = 8;

/// A view of vectors in SoA layout, from which vector instructions load without shuffling.
struct Vec3Span {
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    Vec3Span from(std::size_t first) const { return {x + first, y + first, z + first}; }

    const double *x, *y, *z;
};

/// The same for vectors that may be changed.
struct MutableVec3Span {
    void set(std::size_t i, const Vec3& v) const {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
    MutableVec3Span from(std::size_t first) const { return {x + first, y + first, z + first}; }
    operator Vec3Span() const { return {x, y, z}; }

    double *x, *y, *z;
};

/// A fixed number of vectors in SoA layout.
template <std::size_t most>
struct Vec3Columns {
    void set(std::size_t i, const Vec3& v) { span().set(i, v); }
    void copy(const Vec3Span& from, std::size_t count) {
        std::copy_n(from.x, count, x.begin());
        std::copy_n(from.y, count, y.begin());
        std::copy_n(from.z, count, z.begin());
    }
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    MutableVec3Span span() { return {x.data(), y.data(), z.data()}; }
    Vec3Span span() const { return {x.data(), y.data(), z.data()}; }

    std::array<double, most> x, y, z;
};

/// A padded column of values. It is meant to be refilled: its capacity only grows.
template <class T>
struct PaddedColumn {
    /// Makes room for `count` values. Existing values are kept, new ones are zero.
    void make_room(std::size_t count) {
        const std::size_t room = count + padded_doubles;
        if (values.size() < room) values.resize(std::max(room, 2 * values.size()));
    }

    T& operator[](std::size_t i) { return values[i]; }
    const T& operator[](std::size_t i) const { return values[i]; }
    T* data() { return values.data(); }
    const T* data() const { return values.data(); }

    std::vector<T> values;
};

/// Vectors in SoA layout in such columns.
struct Vec3Buffer {
    void make_room(std::size_t count) {
        for (auto* column : {&x, &y, &z}) column->make_room(count);
    }

    void set(std::size_t i, const Vec3& v) { span().set(i, v); }
    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    MutableVec3Span span() { return {x.data(), y.data(), z.data()}; }
    Vec3Span span() const { return {x.data(), y.data(), z.data()}; }

    PaddedColumn<double> x, y, z;
};

}  // namespace etalon
