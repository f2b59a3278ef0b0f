// A scene of each format to be damaged by tests.
#pragma once

#include <string>
#include <vector>

namespace etalon {

struct WholeScene {
    std::string format;
    std::string text;         ///< every kind of statement, well formed
    std::size_t diagnostics;  ///< number of diagnostics that it gives nevertheless
    std::size_t primitives;
    std::string camera;                ///< a good camera and nothing else
    std::string bad_statement;         ///< a line that gives one warning
    std::string camera_keyword;        ///< first word of a camera
    std::vector<std::string> words;    ///< words for random texts
    std::size_t bytes_of_a_byte = 40;  ///< most memory of the scene, per byte of text
};

const std::vector<WholeScene>& whole_scenes();

}  // namespace etalon
