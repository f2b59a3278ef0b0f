// Loading P3F text in a test.
#pragma once

#include "tests/formats/messages.h"

namespace etalon {

/// A good camera. It comes last in a text, so that the lines under test count from 1.
inline const std::string good_camera =
    "camera\neye 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 40 30\n"
    "aperture 0\nfocal 1\n";

inline const std::string good_material = "mat 1 1 1 0.5 1 1 1 0 10 0 1\n";

inline LoadResult load_p3f_text(const std::string& text, const LoadOptions& options = {}) {
    return load_text("p3f", text, options);
}

/// `text` before a good camera.
inline LoadResult load_statements(const std::string& text, const LoadOptions& options = {}) {
    return load_p3f_text(text + "\n" + good_camera, options);
}

/// `text` before a good camera, its objects of a good material. The first line is the material's.
inline LoadResult load_objects(const std::string& text, const LoadOptions& options = {}) {
    return load_statements(good_material + text, options);
}

}  // namespace etalon
