#include "native_accel/bvh/builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

constexpr int max_bins = 32;

using Primitives = std::span<BoundedPrimitive>;

Vec3f twice_centre(const Box3f& box) {
    return box.min + box.max;
}

/// Half the surface; 0 for an empty box.
float half_area(const Box3f& box) {
    if (box.isEmpty()) return 0;
    const Vec3f s = box.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// Of testing so many primitives, `lanes` of them at once.
float test_cost(std::size_t count, std::uint32_t lanes) {
    return static_cast<float>((count + lanes - 1) / lanes);
}

struct Bin {
    Box3f box;
    std::uint32_t count = 0;

    void add(const Bin& other) {
        box.extendBy(other.box);
        count += other.count;
    }
};

/// Maps a centre to its bin along each axis; the same arithmetic for counting and partitioning.
struct Binning {
    Binning(const Box3f& centres, int bin_count) : origin(centres.min), bins(bin_count) {
        const Vec3f size = centres.size();
        for (int k = 0; k < 3; ++k) {
            scale[k] = size[k] > 0 ? static_cast<float>(bins) / size[k] : 0.0F;
            if (!std::isfinite(scale[k])) scale[k] = 0;  // an extent too small to divide by
        }
    }

    int bin(const Vec3f& centre, int axis) const {
        const float position = (centre[axis] - origin[axis]) * scale[axis];
        return std::min(static_cast<int>(position), bins - 1);
    }

    Vec3f origin, scale;
    int bins;
};

struct Bins {
    std::array<std::array<Bin, max_bins>, 3> axis;

    void count(const Binning& binning, std::span<const BoundedPrimitive> primitives) {
        for (const BoundedPrimitive& p : primitives) {
            const Vec3f centre = twice_centre(p.box);
            for (int k = 0; k < 3; ++k) axis[k][binning.bin(centre, k)].add({p.box, 1});
        }
    }
};

/// Primitives whose bin along `axis` is below `bin` go left.
struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    int bin = 0;
};

/// The cheapest plane of one axis, by sweeping areas from both ends.
Split cheapest_plane(const std::array<Bin, max_bins>& bins, const BvhConfig& config, int axis) {
    std::array<float, max_bins> right_cost{};
    Bin right;
    for (int i = config.bins - 1; i > 0; --i) {
        right.add(bins[i]);
        right_cost[i] = right.count == 0
                            ? Split().cost
                            : half_area(right.box) * test_cost(right.count, config.lanes);
    }
    Split best;
    Bin left;
    for (int i = 1; i < config.bins; ++i) {
        left.add(bins[i - 1]);
        if (left.count == 0) continue;
        const float cost =
            half_area(left.box) * test_cost(left.count, config.lanes) + right_cost[i];
        if (cost < best.cost) best = {cost, axis, i};
    }
    return best;
}

Split cheapest_plane(const Bins& bins, const BvhConfig& config) {
    Split best;
    for (int k = 0; k < 3; ++k) {
        const Split split = cheapest_plane(bins.axis[k], config, k);
        if (split.cost < best.cost) best = split;
    }
    return best;
}

class Builder {
  public:
    Builder(Primitives primitives, const BvhConfig& config)
        : first_(primitives.data()), config_(config), nodes_(2 * primitives.size()) {
        build(0, primitives, 0);
    }

    std::vector<BvhNode> take_nodes() {
        nodes_.resize(next_);
        nodes_.shrink_to_fit();
        return std::move(nodes_);
    }

  private:
    void build(std::uint32_t node, Primitives primitives, int depth) {
        Box3f box, centres;
        for (const BoundedPrimitive& p : primitives) {
            box.extendBy(p.box);
            centres.extendBy(twice_centre(p.box));
        }
        const std::size_t middle = choose_split(primitives, box, centres, depth);
        if (middle == 0) {
            const auto first = static_cast<std::uint32_t>(primitives.data() - first_);
            nodes_[node] = {box, first, static_cast<std::uint32_t>(primitives.size())};
            return;
        }
        const std::uint32_t child = next_.fetch_add(2, std::memory_order_relaxed);
        nodes_[node] = {box, child, 0};
        const auto left = [&] { build(child, primitives.first(middle), depth + 1); };
        const auto right = [&] { build(child + 1, primitives.subspan(middle), depth + 1); };
        if (primitives.size() < config_.serial_below) {
            left();
            right();
        } else {
            parallel_invoke(left, right);
        }
    }

    /// Reorders the primitives and returns how many go left; 0 makes a leaf.
    std::size_t choose_split(Primitives primitives, const Box3f& box, const Box3f& centres,
                             int depth) const {
        const std::size_t count = primitives.size();
        if (count == 1) return 0;
        if (depth >= bvh_heuristic_depth) return count <= config_.max_leaf ? 0 : count / 2;
        const Binning binning(centres, config_.bins);
        Bins bins;
        bins.count(binning, primitives);
        const Split split = cheapest_plane(bins, config_);
        const float area = half_area(box);
        const float leaf_cost = area * test_cost(count, config_.lanes);
        const bool worthwhile = split.cost + area * config_.traversal_cost < leaf_cost;
        if (!worthwhile && count <= config_.max_leaf) return 0;
        if (split.axis < 0) return count / 2;  // all centres fall into one bin
        const auto middle =
            std::partition(primitives.begin(), primitives.end(), [&](const BoundedPrimitive& p) {
                return binning.bin(twice_centre(p.box), split.axis) < split.bin;
            });
        return static_cast<std::size_t>(middle - primitives.begin());
    }

    const BoundedPrimitive* first_;
    const BvhConfig& config_;
    std::vector<BvhNode> nodes_;
    std::atomic<std::uint32_t> next_ = 2;
};

}  // namespace

BvhTree build_bvh(std::vector<BoundedPrimitive> primitives, const BvhConfig& config) {
    BvhTree tree;
    if (primitives.empty()) return tree;
    tree.nodes = Builder(primitives, config).take_nodes();
    tree.ids.reserve(primitives.size());
    for (const BoundedPrimitive& p : primitives) tree.ids.push_back(p.id);
    return tree;
}

}  // namespace etalon
