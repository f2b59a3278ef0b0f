// The vertices of a PLY file.
#pragma once

#include <fmt/core.h>

#include <array>

#include "core/formats/ply/ply.h"
#include "core/formats/ply/ply_numbers.h"

namespace etalon::ply {

/// Destination of the values of a property: target[0], target[stride], ...
struct Column {
    float* target = nullptr;  ///< null: they are skipped
    std::size_t stride = 0;
};

/// Allocates the vertices' arrays in the mesh, and returns the destination of each property.
/// Positions must be among the properties.
std::vector<Column> make_columns(const Element& vertices, PlyMesh& mesh);

/// Sets out[i * stride] to the number at first + i * row_bytes, for i < count.
template <class T, ByteOrder order>
void copy_column(const char* first, std::size_t row_bytes, std::size_t count, const Column& out) {
    for (std::size_t i = 0; i < count; ++i) {
        out.target[i * out.stride] = static_cast<float>(load<T, order>(first + i * row_bytes));
    }
}

/// Reads vertices of constant size, in blocks that stay in the first-level cache while their
/// columns are copied. There must be as many as the element says.
template <ByteOrder order>
void read_columns(BinaryNumbers<order>& in, const Element& vertices, std::vector<Column> columns) {
    const std::size_t row_bytes = vertices.least_bytes();
    const std::size_t block = std::max<std::size_t>(1, (1 << 14) / row_bytes);
    for (std::uint64_t row = 0; row < vertices.count; row += block) {
        const std::size_t count = std::min<std::uint64_t>(block, vertices.count - row);
        const char* first = in.position();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Type type = vertices.properties[i].type;
            if (columns[i].target) {
                with_type(type, [&](auto t) {
                    copy_column<decltype(t), order>(first, row_bytes, count, columns[i]);
                });
                columns[i].target += count * columns[i].stride;
            }
            first += size_of(type);
        }
        in.position() += count * row_bytes;
    }
}

/// Reads the number of a list's values; returns false if it is none.
template <class Source>
bool read_size(Source& in, const Property& list, double& size) {
    if (!in.read(*list.count, size)) return false;
    if (size >= 0 && size < 0x1p32) return true;
    in.fail(fmt::format("found a list of {} values", size));
    return false;
}

/// Skips the values of a list.
template <class Source>
bool skip_list(Source& in, const Property& list) {
    double size = 0;
    return read_size(in, list, size) && in.skip(list.type, static_cast<std::uint64_t>(size));
}

/// Reads one element; returns false at a malformed number.
template <class Source>
bool read_row(Source& in, const Element& vertices, std::vector<Column>& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Property& property = vertices.properties[i];
        double value = 0;
        if (property.count) {
            if (!skip_list(in, property)) return false;
            continue;
        }
        if (!in.read(property.type, value)) return false;
        if (!columns[i].target) continue;
        *columns[i].target = static_cast<float>(value);
        columns[i].target += columns[i].stride;
    }
    return true;
}

/// Reads the vertices into their columns; without columns, skips elements. Returns false at a
/// malformed number. The source must hold all of them.
template <class Source>
bool read_elements(Source& in, const Element& elements, std::vector<Column> columns) {
    if (elements.properties.empty()) return true;
    if constexpr (Source::is_binary) {
        if (!elements.has_lists()) {
            read_columns(in, elements, std::move(columns));
            return true;
        }
    }
    for (std::uint64_t row = 0; row < elements.count; ++row) {
        if (!read_row(in, elements, columns)) return false;
    }
    return true;
}

}  // namespace etalon::ply
