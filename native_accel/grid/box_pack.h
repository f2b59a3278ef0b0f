#pragma once

#include "core/accel/wide/wide_node.h"
#include "native_accel/grid/cost.h"
#include "native_accel/grid/overlap.h"

namespace etalon {

/// The padded boxes of up to eight clusters, tested at once like the children of a node.
struct BoxPack {
    using Item = BoxItem;  ///< its id is ClusterRef::bits
    static constexpr GridCost cost{node_width, 1, 4, 20};

    BoxPack() { boxes.clear(); }

    void set(std::size_t lane, const BoxItem& item) {
        boxes.set(lane, item.box, ChildRef::leaf(ClusterRef(item.id)));
    }

    WideNode boxes;
};

}  // namespace etalon
