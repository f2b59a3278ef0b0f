// Diagnostics of a loader for the user, each with its place in a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace etalon {

enum class Severity : std::uint8_t { warning, error };

struct Diagnostic {
    Severity severity;
    std::string kind;  ///< short stable tag; those of one kind and severity are counted together
    std::string file;
    int line;              ///< from 1; 0 if the message is about the file as a whole
    int column;            ///< number from 1, in bytes
    std::string message;   ///< what is wrong, and what was expected
    std::size_t more = 0;  ///< number of further ones of this kind, which were not kept
};

/// Number of diagnostics of a kind that are shown.
inline constexpr int diagnostics_of_a_kind = 20;

/// Returns "FILE:LINE:COLUMN: error|warning: message": a printable() line of bounded length.
std::string to_string(const Diagnostic& diagnostic);

/// Returns the diagnostics as text, one per line: at most `limit` of a kind, then how many more
/// there were.
std::string report(const std::vector<Diagnostic>& diagnostics, int limit = diagnostics_of_a_kind);

}  // namespace etalon
