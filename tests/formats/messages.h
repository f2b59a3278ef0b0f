// Messages of a loader, as text.
#pragma once

#include <string>
#include <vector>

#include "core/formats/load.h"

namespace etalon {

using Messages = std::vector<std::string>;

inline Messages messages(const LoadResult& result) {
    Messages list;
    for (const Diagnostic& d : result.diagnostics) list.push_back(to_string(d));
    return list;
}

/// Reads `text` as the file "a.<format>".
inline LoadResult load_text(const std::string& format, const std::string& text,
                            LoadOptions options = {}) {
    options.format = format;
    return load_scene_text(text, "a." + format, options);
}

}  // namespace etalon
