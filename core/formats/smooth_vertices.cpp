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

std::uint32_t hash_of(const Vec3& position, const Vec3& normal) {
    std::uint64_t h = 0;
    for (const Vec3& v : {position, normal}) {
        for (const std::uint64_t bits : bits_of(v)) {
            h = (h ^ bits) * 0x9E3779B97F4A7C15U;  // Fibonacci hashing (Knuth 1998, section 6.4)
            h ^= h >> 32;
        }
    }
    return static_cast<std::uint32_t>(h);
}

}  // namespace

std::uint32_t SmoothVertices::number(Geometry& geometry, const Vec3& position, const Vec3& normal) {
    if (geometry.normal_offset() != normal_offset_) {
        table_.clear();
        size_ = 0;
        normal_offset_ = geometry.normal_offset();
    }
    if (2 * size_ >= table_.size()) grow();
    const std::uint32_t hash = hash_of(position, normal);
    std::size_t place = first_place(hash);
    for (; table_[place].vertex != no_index; place = next_place(place)) {
        const auto [known_hash, vertex] = table_[place];
        if (known_hash == hash && same_bits(geometry.vertices[vertex], position) &&
            same_bits(geometry.normals[vertex - normal_offset_], normal)) {
            return vertex;
        }
    }
    ++size_;
    table_[place] = {hash, geometry.add_vertex(position, normal)};
    return table_[place].vertex;
}

void SmoothVertices::grow() {
    std::vector<Entry> before(std::max<std::size_t>(64, 4 * table_.size()));
    before.swap(table_);
    for (const Entry& entry : before) {
        if (entry.vertex == no_index) continue;
        std::size_t place = first_place(entry.hash);
        while (table_[place].vertex != no_index) place = next_place(place);
        table_[place] = entry;
    }
}

}  // namespace etalon
