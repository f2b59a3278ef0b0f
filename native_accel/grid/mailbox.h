#pragma once

#include <array>
#include <cstdint>

#include "core/scene/shapes.h"

namespace etalon {

/// The primitives that a ray was tested against last, so that one that lies in many cells is not
/// tested in each (Amanatides & Woo 1987). It may forget, but never makes up.
class Mailbox {
  public:
    Mailbox() { ids_.fill(no_index); }

    /// Whether the primitive is not among them; it then is.
    bool add(std::uint32_t id) {
        std::uint32_t& last = ids_[id % ids_.size()];
        if (last == id) return false;
        last = id;
        return true;
    }

  private:
    std::array<std::uint32_t, 8> ids_;
};

}  // namespace etalon
