// Scenes of at most a kilobyte that ask for gigabytes or hours.
#pragma once

#include <string>
#include <vector>

namespace etalon::test {

struct SmallBomb {
    std::string name;     ///< what it tries
    std::string format;   ///< extension of the scene
    std::string text;     ///< text of the scene
    std::string file{};   ///< name of a file beside it, if it has one
    std::string bytes{};  ///< contents of that file
};

std::vector<SmallBomb> small_bombs();

}  // namespace etalon::test
