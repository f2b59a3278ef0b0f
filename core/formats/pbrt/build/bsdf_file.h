// Files of tabulated BSDFs.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/fourier_table.h"

namespace etalon::pbrt {

/// Parses the bytes of a file in the format of Jakob's layerlab, as far as pbrt-v3 reads it:
/// without texture parameters, and with one or three channels.
Result<FourierTable> parse_bsdf_file(std::string_view bytes);

/// Reads each file once.
class BsdfFiles {
  public:
    /// A table, or why there is none.
    using Table = Result<std::shared_ptr<const FourierTable>>;

    const Table& read(const std::string& path);

  private:
    std::map<std::string, Table> tables_;
};

}  // namespace etalon::pbrt
