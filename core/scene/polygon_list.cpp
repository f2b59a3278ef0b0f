#include "core/scene/polygon_list.h"

#include "core/scene/projected_outline.h"
#include "core/scene/spare_room.h"

namespace etalon {
namespace {

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
    const std::size_t length = edges_in_columns(entry) + 1;
    const auto columns = std::span(columns_).subspan(entry.columns, 2 * length);
    project_outline(corners_of(entry), entry.facts, columns.first(length), columns.last(length));
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
