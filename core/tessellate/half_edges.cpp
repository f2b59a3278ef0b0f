#include "core/tessellate/half_edges.h"

#include <algorithm>

namespace etalon {

std::optional<HalfEdges> HalfEdges::of(std::span<const std::uint32_t> corners,
                                       std::size_t vertices) {
    HalfEdges edges;
    edges.corners_ = corners;
    edges.twins_.assign(corners.size(), none);
    edges.first_.assign(vertices, none);
    struct Entry {
        std::uint64_t key;  ///< from and to
        std::uint32_t edge;
    };
    std::vector<Entry> sorted;
    sorted.reserve(corners.size());
    const auto key = [](std::uint64_t a, std::uint64_t b) { return a << 32 | b; };
    for (std::uint32_t h = 0; h < corners.size(); ++h) {
        sorted.push_back({key(edges.from(h), edges.to(h)), h});
    }
    std::ranges::sort(sorted, {}, &Entry::key);
    if (std::ranges::adjacent_find(sorted, {}, &Entry::key) != sorted.end()) return std::nullopt;
    for (std::uint32_t h = 0; h < corners.size(); ++h) {
        const std::uint64_t wanted = key(edges.to(h), edges.from(h));
        const auto found = std::ranges::lower_bound(sorted, wanted, {}, &Entry::key);
        if (found != sorted.end() && found->key == wanted) edges.twins_[h] = found->edge;
    }
    for (std::uint32_t h = 0; h < corners.size(); ++h) {
        std::uint32_t& first = edges.first_[corners[h]];
        if (first == none || edges.twins_[h] == none) first = h;
    }
    return edges;
}

void HalfEdges::ring(std::uint32_t vertex, std::vector<std::uint32_t>& to) const {
    to.clear();
    const std::uint32_t first = first_of(vertex);
    std::uint32_t h = first;
    do {
        to.push_back(this->to(h));
        const std::uint32_t back = previous(h);
        h = twin(back);
        if (h == none) to.push_back(from(back));
    } while (h != none && h != first);
}

}  // namespace etalon
