#include "core/scene/polygon_list.h"

#include <algorithm>

#include "core/scene/spare_room.h"

namespace etalon {
namespace {

/// Least number of corners of a polygon with columns: for fewer, kernels gain nothing from them.
constexpr std::size_t least_corners_for_columns = 8;

template <class T>
std::uint32_t append(LargeVector<T>& to, std::span<const T> items) {
    const auto first = static_cast<std::uint32_t>(to.size());
    to.insert(to.end(), items.begin(), items.end());
    return first;
}

}  // namespace

void PolygonList::push_back(const Polygon& polygon) {
    Entry entry{
        {}, append(corners_, polygon.corners), static_cast<std::uint32_t>(polygon.corners.size())};
    if (!polygon.normals.empty()) entry.normals = append(normals_, polygon.normals);
    if (entry.count >= least_corners_for_columns) {
        entry.columns = static_cast<std::uint32_t>(columns_.size());
        columns_.resize(columns_.size() + 2 * (edges_in_columns(entry) + 1));
    }
    work_out(entry);
    entries_.push_back(entry);
}

void PolygonList::make_room(double factor) {
    const auto grow = [&](auto& list) {
        list.reserve(static_cast<std::size_t>(static_cast<double>(list.size()) * factor));
    };
    grow(entries_);
    grow(corners_);
    grow(normals_);
    grow(columns_);
}

void PolygonList::work_out(Entry& entry) {
    entry.facts = PolygonFacts(corners_of(entry));
    if (entry.columns != none) fill_columns(entry);
}

void PolygonList::fill_columns(const Entry& entry) {
    const std::span<const Vec3> corners = corners_of(entry);
    const auto& [plane, box, projection] = entry.facts;
    const std::size_t length = edges_in_columns(entry) + 1;
    double *x = &columns_[entry.columns], *y = x + length;
    for (std::size_t i = 0; i < length; ++i) {
        const std::size_t last = corners.size() - 1;
        const Vec3 p = corners[i == 0 ? last : std::min(i - 1, last)] - box.min;
        x[i] = p[projection.x_axis()] * projection.scale.x;
        y[i] = p[projection.y_axis()] * projection.scale.y;
    }
}

void PolygonList::shrink_to_fit() {
    release_spare_capacity(entries_);
    release_spare_capacity(corners_);
    release_spare_capacity(normals_);
    release_spare_capacity(columns_);
}

std::size_t PolygonList::memory_bytes() const {
    return written_bytes(entries_) + written_bytes(corners_) + written_bytes(normals_) +
           written_bytes(columns_);
}

}  // namespace etalon
