#include "core/shading/hit_order.h"

#include <array>

namespace etalon {
namespace {

/// Rays that have hit a primitive, as a list of which each ray names the next.
struct PrimitiveHits {
    std::uint32_t primitive = no_index;
    std::uint32_t count = 0;
    std::uint32_t first = no_index;
};

/// A list for each of as many primitives. Of those with the same place in it, one has it.
using PrimitiveTable = std::array<PrimitiveHits, 128>;

/// Fewer hits on a primitive than this are not worth a run.
constexpr std::uint32_t least_run = 4;

}  // namespace

HitOrder::HitOrder(std::span<const Hit> hits) {
    PrimitiveTable table;
    std::vector<std::uint32_t> next(hits.size()), others;
    for (auto i = static_cast<std::uint32_t>(hits.size()); i-- > 0;) {
        const Hit& hit = hits[i];
        if (hit.primitive == no_index) continue;
        PrimitiveHits& list = table[hit.primitive % table.size()];
        if (list.count == 0) list.primitive = hit.primitive;
        if (list.primitive != hit.primitive || hit.instance != no_index) {
            others.push_back(i);
            continue;
        }
        next[i] = list.first;
        list.first = i;
        ++list.count;
    }
    rays.reserve(hits.size());
    const auto append = [&](const PrimitiveHits& list) {
        for (std::uint32_t i = list.first; i != no_index; i = next[i]) rays.push_back(i);
    };
    for (const PrimitiveHits& list : table) {
        if (list.count < least_run) continue;
        const auto first = static_cast<std::uint32_t>(rays.size());
        append(list);
        runs.push_back({first, first + list.count, list.primitive});
    }
    in_runs = rays.size();
    for (const PrimitiveHits& list : table) {
        if (list.count < least_run) append(list);
    }
    rays.insert(rays.end(), others.rbegin(), others.rend());
}

}  // namespace etalon
