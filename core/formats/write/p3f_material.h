#pragma once

#include "core/formats/p3f/p3f_statement.h"
#include "core/formats/write/conversion_warnings.h"

namespace etalon {

/// Statement of a material; `absorbs` for a `mat`, not an `f`.
struct P3fStatement {
    P3fMaterial numbers;
    bool absorbs;
};

/// Returns the statement from which a P3F reader makes this material, to the last bit if it ever
/// came from one; else the closest one, with warnings of what is lost.
P3fStatement to_p3f(const Material& material, ConversionWarnings& lost);

}  // namespace etalon
