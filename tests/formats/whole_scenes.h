// A scene of each format to be damaged by tests.
#pragma once

#include <string>
#include <vector>

namespace etalon {

struct WholeScene {
    std::string format;
    std::string text;         ///< every kind of statement, well formed
    std::size_t diagnostics;  ///< how many it gives all the same
    std::size_t primitives;
    std::string camera;                ///< a good camera and nothing else
    std::string bad_statement;         ///< a line that gives one warning
    std::string camera_keyword;        ///< what a camera starts with
    std::vector<std::string> words;    ///< to throw together
    std::size_t bytes_of_a_byte = 40;  ///< of text, that the scene may take at most
};

const std::vector<WholeScene>& whole_scenes();

}  // namespace etalon
