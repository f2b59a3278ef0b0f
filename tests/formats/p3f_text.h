// Loading P3F text in a test.
#pragma once

#include <string>
#include <vector>

#include "core/formats/load.h"

namespace etalon {

/// A good camera, as the last thing of a text so that the lines of what is tested count from 1.
inline const std::string good_camera =
    "camera\neye 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 40 30\n"
    "aperture 0\nfocal 1\n";

inline const std::string good_material = "mat 1 1 1 0.5 1 1 1 0 10 0 1\n";

inline LoadResult load_p3f_text(const std::string& text, LoadOptions options = {}) {
    options.format = "p3f";
    return load_scene_text(text, "a.p3f", options);
}

/// `text` before a good camera.
inline LoadResult load_statements(const std::string& text, const LoadOptions& options = {}) {
    return load_p3f_text(text + "\n" + good_camera, options);
}

/// `text` before a good camera, its objects of a good material. The first line is the material's.
inline LoadResult load_objects(const std::string& text, const LoadOptions& options = {}) {
    return load_statements(good_material + text, options);
}

inline std::vector<std::string> messages(const LoadResult& result) {
    std::vector<std::string> list;
    for (const Diagnostic& d : result.diagnostics) list.push_back(to_string(d));
    return list;
}

using Messages = std::vector<std::string>;

}  // namespace etalon
