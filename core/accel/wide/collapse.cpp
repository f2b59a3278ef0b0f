#include "core/accel/wide/collapse.h"

#include <limits>

#include "core/parallel/parallel.h"

namespace etalon {

Collapse::Collapse(const std::vector<BvhNode>& nodes)
    : nodes_(nodes), plans_(std::make_unique_for_overwrite<Plan[]>(nodes.size() / 2)) {
    plan_all(root());
}

/// Splits a branch: descendants of the left child end where those of the right child begin.
std::array<Branch, 2> Collapse::halves(const Branch& branch) const {
    const BvhNode* const left = &nodes_[branch.node->first];
    const BvhNode* const right = left + 1;
    return {Branch{left, right->is_leaf() ? branch.end : right->first}, Branch{right, branch.end}};
}

/// Children come after their parents.
void Collapse::plan_all(const Branch& branch) {
    constexpr std::size_t serial_up_to = 1024;
    if (branch.is_leaf()) return;
    if (branch.size() > serial_up_to) {
        const auto [left, right] = halves(branch);
        parallel_invoke([&, one = left] { plan_all(one); }, [&, one = right] { plan_all(one); });
    } else {
        for (std::size_t i = branch.end; i-- > branch.end - branch.size();) {
            const BvhNode& node = nodes_[i];
            if (!node.is_leaf()) plan_of(node) = plan(node);
        }
    }
    plan_of(*branch.node) = plan(*branch.node);
}

Collapse::Plan Collapse::plan(const BvhNode& inner) const {
    Plan plan{};
    const Plan &left = plan_or_none(nodes_[inner.first]),
               &right = plan_or_none(nodes_[inner.first + 1]);
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
    plan.cost[1] = half_area(inner.box) + cost[node_width];
    for (std::size_t count = 2; count < node_width; ++count) {
        const bool pays = cost[count] < plan.cost[count - 1];
        plan.cost[count] = pays ? cost[count] : plan.cost[count - 1];
        if (!pays) plan.first[count] = 0;
    }
    return plan;
}

Branches Collapse::children(const Branch& branch) const {
    const std::size_t first = plan_of(*branch.node).first[node_width];
    const auto [left, right] = halves(branch);
    Branches list;
    gather(left, first, list);
    gather(right, node_width - first, list);
    return list;
}

void Collapse::gather(const Branch& branch, std::size_t count, Branches& list) const {
    const Plan& plan = plan_or_none(*branch.node);
    while (count > 1 && plan.first[count] == 0) --count;
    if (count == 1) return list.push_back(branch);
    const auto [left, right] = halves(branch);
    gather(left, plan.first[count], list);
    gather(right, count - plan.first[count], list);
}

}  // namespace etalon
