#pragma once

#include "core/base/result.h"
#include "core/image/oiio_abi.h"

namespace etalon {

/// Returns the functions of etalon_oiio.so, which is loaded at the first call: from the folder
/// ETALON_MODULE_PATH if that is set, else from ../lib or ../lib/etalon beside the program's own
/// folder. Thread-safe.
const Result<const EtalonOiio*>& load_oiio();

}  // namespace etalon
