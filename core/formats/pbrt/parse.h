#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"
#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Returns whether a word is a directive of PBRT, of this version or another.
bool is_directive(std::string_view word);

struct ParseOptions {
    bool strict = false;     ///< warnings are errors
    std::string root;        ///< as LoadOptions::root
    bool one_sided = false;  ///< as LoadOptions::one_sided, which PBRT scenes cannot be
};

struct ParsedFile {
    std::vector<Frame> frames;
    std::vector<std::string> files;  ///< names of the files read, for FileLoc
    std::vector<Diagnostic> diagnostics;
    bool is_fatal = false;  ///< pbrt-v3 stops at one of the errors; it continues after others
};

/// Reads PBRT v3 and the files it includes. `path` names the text in diagnostics; files that the
/// text names are relative to the directory of `path`. Throws nothing but std::bad_alloc.
ParsedFile parse(std::string_view text, const std::string& path, const ParseOptions& options = {});

}  // namespace etalon::pbrt
