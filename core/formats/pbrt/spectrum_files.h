#pragma once

#include <string>
#include <unordered_map>

#include "core/formats/pbrt/token_stream.h"
#include "core/numerics/vec.h"

namespace etalon::pbrt {

/// Colours of the spectra that a scene names as files, each read once.
class SpectrumFiles {
  public:
    SpectrumFiles(const TokenStream& tokens, Log& log) : tokens_(tokens), log_(log) {}

    /// Returns the colour of a file; black, with a warning, if it cannot be read.
    Color color(const std::string& name, FileLoc where);

  private:
    Color read(const std::string& path, FileLoc where);

    const TokenStream& tokens_;
    Log& log_;
    std::unordered_map<std::string, Color> colors_;
};

}  // namespace etalon::pbrt
