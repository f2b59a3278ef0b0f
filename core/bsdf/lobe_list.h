#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/bsdf/lobe.h"

namespace etalon {

/// Up to twelve lobes, which are summed: those of any two materials.
class LobeList {
  public:
    static constexpr std::size_t capacity = 12;

    LobeList() {}
    LobeList(const LobeList& other) { *this = other; }
    LobeList& operator=(const LobeList& other) {
        count_ = other.count_;
        has_smooth_ = other.has_smooth_;
        has_smooth_transmission_ = other.has_smooth_transmission_;
        std::uninitialized_copy_n(other.lobes_.begin(), count_, lobes_.begin());
        return *this;
    }
    ~LobeList() = default;

    /// Adds a lobe; lobes beyond the capacity are dropped.
    template <class Kind>
    void add(const Kind& lobe) {
        if (count_ == capacity) return;
        std::construct_at(lobes_.data() + count_++, lobe);
        has_smooth_ |= Kind::kind != LobeKind::specular;
        has_smooth_transmission_ |= scatters_to(LobeKind::transmission, Kind::kind);
    }
    void add(const Lobe& lobe) {
        visit_lobe([&](const auto& kind) { add(kind); }, lobe);
    }

    /// Scales the lobes from number `first` on.
    void scale(std::size_t first, const Color& by) {
        for (std::size_t k = first; k < count_; ++k) {
            visit_lobe([&](auto& lobe) { lobe.scale(by); }, lobes_[k]);
        }
    }

    /// Returns whether any lobe is not specular.
    bool has_smooth() const { return has_smooth_; }

    /// Returns whether any smooth lobe transmits light through the surface.
    bool has_smooth_transmission() const { return has_smooth_transmission_; }

    std::size_t size() const { return count_; }
    const Lobe& operator[](std::size_t k) const { return lobes_[k]; }
    std::span<const Lobe> span() const { return {lobes_.data(), count_}; }

  private:
    static_assert(std::is_trivially_destructible_v<Lobe>);

    std::size_t count_ = 0;
    bool has_smooth_ = false, has_smooth_transmission_ = false;
    union {
        std::array<Lobe, capacity> lobes_;  // the first count_ live
    };
};

}  // namespace etalon
