// Interface of a fuzz target: each target is one file that defines `target`; frame.cpp has
// libFuzzer's entry points.
#pragma once

#include <string_view>

namespace etalon::fuzz {

struct Target {
    /// Reads an input. Aborts the process if the result is invalid.
    void (*run)(std::string_view input);
    bool is_text = false;  ///< also mutate words and numbers as a whole
    /// True if any allocation may fail without a leak. OpenEXR and OpenImageIO leak; nlohmann-json
    /// and CLI11 end the program when an allocation fails in a noexcept function.
    bool survives_lack_of_memory = true;
};

extern const Target target;

/// Aborts the process unless `holds`; `text` is the finding that it prints.
void require(bool holds, std::string_view text);

}  // namespace etalon::fuzz
