#pragma once

#include <cstdint>

#include "core/parallel/large_pages.h"
#include "core/scene/polygon.h"
#include "core/scene/value_iterator.h"

namespace etalon {

/// Many polygons with private copies of their corners. What is derived from the corners is
/// recomputed whenever they change, and so never stale.
class PolygonList {
  public:
    using value_type = Polygon;

    std::size_t size() const { return entries_.size(); }
    bool empty() const { return entries_.empty(); }
    void push_back(const Polygon& polygon);

    /// Reserves space for `factor` times as many polygons of this kind.
    void make_room(double factor);

    StoredPolygon operator[](std::size_t i) const {
        const Entry& e = entries_[i];
        return {{corners_of(e), normals_of(e)}, e.facts, columns_of(e)};
    }

    ValueIterator<PolygonList> begin() const { return {*this, 0}; }
    ValueIterator<PolygonList> end() const { return {*this, size()}; }

    /// Returns the corners of all polygons, one after the other.
    std::span<const Vec3> corners() const { return corners_; }
    bool have_normals() const { return !normals_.empty(); }

    /// Calls change(corner) for every corner, which may move it.
    template <class Change>
    void change_corners(const Change& change) {
        for (Vec3& corner : corners_) change(corner);
        for (Entry& e : entries_) work_out(e);
    }

    void shrink_to_fit();
    std::size_t memory_bytes() const;

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFFU;

    struct Entry {
        PolygonFacts facts;
        std::uint32_t first, count;    ///< among all corners
        std::uint32_t normals = none;  ///< number of the first normal
        std::uint32_t columns = none;  ///< index of the first coordinate in the first column
    };

    std::span<const Vec3> corners_of(const Entry& e) const {
        return {corners_.data() + e.first, e.count};
    }
    std::span<const Vec3> normals_of(const Entry& e) const {
        if (e.normals == none) return {};
        return {normals_.data() + e.normals, e.count};
    }
    static std::size_t edges_in_columns(const Entry& e) {
        constexpr std::size_t lanes = OutlineColumns::lanes;
        return (e.count + lanes - 1) / lanes * lanes;
    }
    OutlineColumns columns_of(const Entry& e) const {
        if (e.columns == none) return {};
        const double* x = columns_.data() + e.columns;
        const std::size_t edges = edges_in_columns(e);
        return {x, x + edges + 1, edges};
    }

    /// Recomputes what is derived from the corners.
    void work_out(Entry& entry);
    void fill_columns(const Entry& entry);

    LargeVector<Entry> entries_;
    LargeVector<Vec3> corners_, normals_;
    LargeVector<double> columns_;
};

}  // namespace etalon
