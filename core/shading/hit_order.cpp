#include "core/shading/hit_order.h"

#include "core/numerics/vec_columns.h"

namespace etalon {
namespace {

/// Least number of hits on a primitive that form a run: fewer are not worth one.
constexpr std::uint32_t least_run = 4;

}  // namespace

void HitOrder::add(const Neighbours& some, const Hit& hit) {
    const auto slot = static_cast<std::uint32_t>(hit.primitive % table_.size());
    PrimitiveHits& list = table_[slot];
    const bool is_unused = list.count == 0;
    if (hit.instance != no_index || (!is_unused && list.primitive != hit.primitive)) {
        others_.push_back(some);
        return;
    }
    const auto number = static_cast<std::uint32_t>(neighbours_.size());
    if (is_unused) {
        list = {.primitive = hit.primitive, .first = number};
        used_.push_back(slot);
    } else {
        neighbours_[list.last].next = number;
    }
    list.last = number;
    list.count += some.last - some.first;
    neighbours_.push_back(some);
}

std::size_t HitOrder::append(const Neighbours& some, std::size_t at) {
    for (std::uint32_t i = some.first; i < some.last; ++i) rays[at++] = i;
    return at;
}

std::size_t HitOrder::append(const PrimitiveHits& list, std::size_t at) {
    for (std::uint32_t i = list.first; i != no_index; i = neighbours_[i].next) {
        at = append(neighbours_[i], at);
    }
    return at;
}

void HitOrder::find(std::span<const Hit> hits) {
    for (const std::uint32_t slot : used_) table_[slot] = {};
    used_.clear();
    runs.clear();
    neighbours_.clear();
    others_.clear();
    rays.resize(std::max(rays.size(), hits.size() + padded_doubles));
    const auto count = static_cast<std::uint32_t>(hits.size());
    for (std::uint32_t first = 0, last = 0; first < count; first = last) {
        const Hit& hit = hits[first];
        for (last = first + 1; last < count && hits[last].primitive == hit.primitive &&
                               hits[last].instance == hit.instance;) {
            ++last;
        }
        if (hit.primitive != no_index) add({first, last, no_index}, hit);
    }
    size = 0;
    for (const std::uint32_t slot : used_) {
        const PrimitiveHits& list = table_[slot];
        if (list.count < least_run) continue;
        const auto first = static_cast<std::uint32_t>(size);
        size = append(list, size);
        runs.push_back({first, first + list.count, list.primitive});
    }
    in_runs = size;
    for (const std::uint32_t slot : used_) {
        if (table_[slot].count < least_run) size = append(table_[slot], size);
    }
    for (const Neighbours& some : others_) size = append(some, size);
    std::fill_n(rays.begin() + static_cast<std::ptrdiff_t>(size), padded_doubles, 0);
}

}  // namespace etalon
