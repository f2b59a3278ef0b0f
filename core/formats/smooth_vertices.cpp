#include "core/formats/smooth_vertices.h"

#include <bit>

namespace etalon {
namespace {

std::array<std::uint64_t, 3> bits_of(const Vec3& v) {
    return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
            std::bit_cast<std::uint64_t>(v.z)};
}

bool same_bits(const Vec3& a, const Vec3& b) {
    return bits_of(a) == bits_of(b);
}

std::uint64_t hash_of(const Vec3& position, const Vec3& normal) {
    std::uint64_t h = 0;
    for (const Vec3& v : {position, normal}) {
        for (const std::uint64_t bits : bits_of(v)) {
            h = (h ^ bits) * 0x9E3779B97F4A7C15U;  // Fibonacci hashing (Knuth 1998, section 6.4)
            h ^= h >> 32;
        }
    }
    return h;
}

}  // namespace

std::uint32_t SmoothVertices::number(Geometry& geometry, const Vec3& position, const Vec3& normal) {
    if (geometry.normal_offset() != normal_offset_) {
        table_.clear();
        size_ = 0;
        normal_offset_ = geometry.normal_offset();
    }
    if (2 * size_ >= table_.size()) grow(geometry);
    std::uint32_t& entry = table_[place_of(geometry, position, normal)];
    if (entry == no_index) {
        entry = geometry.add_vertex(position, normal);
        ++size_;
    }
    return entry;
}

/// Returns the vertex's place in the table, or the empty place where it belongs.
std::size_t SmoothVertices::place_of(const Geometry& geometry, const Vec3& position,
                                     const Vec3& normal) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t place = hash_of(position, normal) & mask;
    while (table_[place] != no_index &&
           !(same_bits(geometry.vertices[table_[place]], position) &&
             same_bits(geometry.normals[table_[place] - normal_offset_], normal))) {
        place = (place + 1) & mask;
    }
    return place;
}

void SmoothVertices::grow(const Geometry& geometry) {
    std::vector<std::uint32_t> before(std::max<std::size_t>(64, 2 * table_.size()), no_index);
    before.swap(table_);
    for (const std::uint32_t v : before) {
        if (v == no_index) continue;
        table_[place_of(geometry, geometry.vertices[v], geometry.normals[v - normal_offset_])] = v;
    }
}

}  // namespace etalon
