// Diagnostics of a loader for the user: each carries the place it is about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace etalon {

enum class Severity : std::uint8_t { warning, error };

struct Diagnostic {
    Severity severity;
    std::string kind;  ///< a short stable tag; messages of one kind are counted together
    std::string file;
    int line;              ///< number from 1; 0 where the message is about the file as a whole
    int column;            ///< number from 1, in bytes
    std::string message;   ///< what, and what was expected
    std::size_t more = 0;  ///< further ones of this kind, of which only the number was kept
};

/// How many of a kind are worth a user's time.
inline constexpr int diagnostics_of_a_kind = 20;

/// Returns "FILE:LINE:COLUMN: error|warning: message".
std::string to_string(const Diagnostic& diagnostic);

/// The diagnostics as text, a line each: at most `limit` of a kind, then how many more there were.
std::string report(const std::vector<Diagnostic>& diagnostics, int limit = diagnostics_of_a_kind);

}  // namespace etalon
