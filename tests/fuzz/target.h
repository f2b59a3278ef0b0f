// What a fuzzer feeds: each target is one file that defines `target`; frame.cpp makes libFuzzer's
// entry points of it.
#pragma once

#include <string_view>

namespace etalon::fuzz {

struct Target {
    /// Reads an input. Ends the process if what came of it is not as it must be.
    void (*run)(std::string_view input);
    bool is_text = false;  ///< words and numbers are changed as such, too
    /// True if memory may end anywhere, and nothing is lost. Not so of OpenEXR and OpenImageIO;
    /// nlohmann-json and CLI11 end the program where they need memory in what must not throw.
    bool survives_lack_of_memory = true;
};

extern const Target target;

/// Ends the process, with `text` as the finding, unless `holds`.
void require(bool holds, std::string_view text);

}  // namespace etalon::fuzz
