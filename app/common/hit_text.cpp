#include "app/common/hit_text.h"

#include <fmt/format.h>

namespace etalon {

std::string hit_text(const Geometry& geometry, const Hit& hit) {
    const Primitive p = geometry.holder(hit.instance).primitives[hit.primitive];
    const std::string instance =
        hit.instance == no_index ? std::string() : fmt::format("{}/", hit.instance);
    return fmt::format("hit {:.17g} {} {}{}", hit.t, kind_name(p.kind), instance, hit.primitive);
}

}  // namespace etalon
