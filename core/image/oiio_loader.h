#pragma once

#include "core/base/result.h"
#include "core/image/oiio_abi.h"

namespace etalon {

/// The functions of etalon_oiio.so, loaded at the first call: from the folder ETALON_MODULE_PATH if
/// that is set, else from ../lib or ../lib/etalon beside the program's own folder. Threads may call
/// it at the same time.
const Result<const EtalonOiio*>& load_oiio();

}  // namespace etalon
