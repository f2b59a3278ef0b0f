#pragma once

#include <bit>

#include "core/numerics/rounding.h"
#include "native_accel/grid/builder.h"
#include "native_accel/grid/mailbox.h"
#include "native_accel/grid/ray.h"
#include "native_accel/grid/tree.h"
#include "native_accel/grid/walk.h"

namespace etalon {

/// A grid over shapes of one kind, which its cells hold packed to be filtered four at once.
template <class Pack, class Filter>
class PackedGrid {
  public:
    PackedGrid() = default;

    explicit PackedGrid(const std::vector<typename Pack::Item>& items) {
        if (items.empty()) return;
        Box3 box;
        for (const auto& item : items) box.extendBy(Box3(Vec3(item.box.min), Vec3(item.box.max)));
        box = {box.min - Vec3(grid_padding), box.max + Vec3(grid_padding)};
        box_ = round_outward(box);
        GridConfig config;
        config.pack_cost = Pack::cost;
        tree_ = GridBuilder<typename Pack::Item>(items, config).build(box);
        pack(items);
    }

    /// Calls offer(id) for all that the ray could hit from tmin to tmax, in the frame. It returns
    /// the tmax from then on.
    template <class Offer>
    void visit(const FrameRay& local, const GridRay& ray, float tmin, float tmax,
               const Offer& offer) const {
        if (tree_.root.count == 0) return;
        Float4 entry = broadcast(tmin), exit = broadcast(tmax);
        const Float4 a = (lanes(box_.min, 0) - ray.origin) * ray.reciprocal;
        const Float4 b = (lanes(box_.max, 0) - ray.origin) * ray.reciprocal;
        const Float4 never{0, 0, 0, std::numeric_limits<float>::infinity()};
        entry = max(entry, -min_of_lanes(max(-a, -b) + never));
        exit = min(exit, min_of_lanes(max(a, b) + never));
        if (!(entry[0] <= exit[0])) return;
        Visit<Offer> visit{*this, ray, Filter(local), offer, tmax, {}};
        visit.cell(tree_.root, entry[0], exit[0]);
    }

    std::size_t memory_bytes() const {
        return tree_.nodes.capacity() * sizeof(GridNode) +
               tree_.cells.capacity() * sizeof(GridCell) + packs_.capacity() * sizeof(Pack) +
               ids_.capacity() * sizeof(ids_[0]);
    }

  private:
    using Ids = std::array<std::uint32_t, 4>;

    template <class Offer>
    struct Visit {
        void cell(const GridCell& c, float entry, float exit) {
            if (c.is_grid()) {
                grid(self.tree_.nodes[c.first], entry, std::min(exit, tmax));
            } else {
                list(c);
            }
        }

        void grid(const GridNode& node, float entry, float end) {
            GridWalk walk(node, ray, entry);
            while (true) {
                const GridCell& c = self.tree_.cells[walk.cell()];
                const Float4 exit = walk.exit();
                if (c.count != 0) {
                    cell(c, entry, std::min(exit[0], end));
                    end = std::min(end, tmax);
                }
                entry = exit[0];
                if (entry > end) return;
                walk.advance(exit);
            }
        }

        void list(const GridCell& c) {
            for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
                unsigned candidates = bits(filter.candidates(self.packs_[i], tmax));
                for (; candidates != 0; candidates &= candidates - 1) {
                    const std::uint32_t id = self.ids_[i][std::countr_zero(candidates)];
                    if (mailbox.add(id)) tmax = offer(id);
                }
            }
        }

        const PackedGrid& self;
        const GridRay& ray;
        const Filter filter;
        const Offer& offer;
        float tmax;
        Mailbox mailbox;
    };

    void pack(const std::vector<typename Pack::Item>& items) {
        std::vector<std::uint32_t> listed;
        listed.swap(tree_.items);
        const auto fill = [&](GridCell& c) {
            if (c.is_grid() || c.count == 0) return;
            const auto first = static_cast<std::uint32_t>(packs_.size());
            for (std::uint32_t i = 0; i < c.count; ++i) {
                if (i % 4 == 0) packs_.emplace_back(), ids_.emplace_back();
                const auto& item = items[listed[c.first + i]];
                packs_.back().set(i % 4, item);
                ids_.back()[i % 4] = item.id;
            }
            c = {first, static_cast<std::uint32_t>(packs_.size()) - first};
        };
        fill(tree_.root);
        for (GridCell& c : tree_.cells) fill(c);
        packs_.shrink_to_fit();
        ids_.shrink_to_fit();
        tree_.cells.shrink_to_fit();
        tree_.nodes.shrink_to_fit();
    }

    Box3f box_;
    GridTree tree_;
    std::vector<Pack> packs_;
    std::vector<Ids> ids_;
};

}  // namespace etalon
