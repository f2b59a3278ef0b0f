#include "native_accel/bvh/collapse.h"

#include <limits>

namespace etalon {

/// Children come after their parents.
Collapse::Collapse(const std::vector<BvhNode>& nodes) : nodes_(nodes), plans_(nodes.size()) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (i != 1) plans_[i] = plan(nodes[i]);
    }
}

Collapse::Plan Collapse::plan(const BvhNode& node) const {
    Plan plan;
    plan.cost.fill(0);
    if (node.is_leaf()) return plan;
    const Plan &left = plans_[node.first], &right = plans_[node.first + 1];
    std::array<float, node_width + 1> cost;
    for (std::size_t count = 2; count <= node_width; ++count) {
        cost[count] = std::numeric_limits<float>::infinity();
        for (std::size_t first = 1; first < count; ++first) {
            const std::size_t second = count - first;
            if (first >= node_width || second >= node_width) continue;
            const float sum = left.cost[first] + right.cost[second];
            if (sum >= cost[count]) continue;
            cost[count] = sum;
            plan.first[count] = static_cast<std::uint8_t>(first);
        }
    }
    plan.cost[1] = half_area(node.box) + cost[node_width];
    for (std::size_t count = 2; count < node_width; ++count) {
        const bool pays = cost[count] < plan.cost[count - 1];
        plan.cost[count] = pays ? cost[count] : plan.cost[count - 1];
        if (!pays) plan.first[count] = 0;
    }
    return plan;
}

std::vector<const BvhNode*> Collapse::children(const BvhNode& node) const {
    const std::size_t first = plans_[&node - nodes_.data()].first[node_width];
    std::vector<const BvhNode*> list;
    gather(nodes_[node.first], first, list);
    gather(nodes_[node.first + 1], node_width - first, list);
    return list;
}

void Collapse::gather(const BvhNode& node, std::size_t count,
                      std::vector<const BvhNode*>& list) const {
    const Plan& plan = plans_[&node - nodes_.data()];
    while (count > 1 && plan.first[count] == 0) --count;
    if (count == 1) {
        list.push_back(&node);
        return;
    }
    gather(nodes_[node.first], plan.first[count], list);
    gather(nodes_[node.first + 1], count - plan.first[count], list);
}

}  // namespace etalon
