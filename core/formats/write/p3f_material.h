#pragma once

#include "core/formats/p3f/p3f_statement.h"
#include "core/formats/write/conversion_warnings.h"

namespace etalon {

/// Statement of a material; `absorbs`: a `mat`, not an `f`.
struct P3fStatement {
    P3fMaterial numbers;
    bool absorbs;
};

/// The statement that a P3F reader makes this material of, to the last bit if it ever came from
/// one; else of one as like it as can be, and what of it is lost.
P3fStatement to_p3f(const Material& material, ConversionWarnings& lost);

}  // namespace etalon
