// PRT 1.0, the format of Kory Hamzeh's parallel ray tracer (1994).
#pragma once

#include "core/formats/load.h"

namespace etalon {

LoadResult load_prt(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
