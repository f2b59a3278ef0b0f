// Limit of the memory of the programs. An allocation beyond it fails with an error message; without
// a limit the system would kill them, or other programs, silently.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace etalon {

/// Returns the bytes of "500M", "4 GB" or "1.5GiB" (K, M, G, T: powers of 1000; with i, of 1024);
/// nothing for a malformed size.
std::optional<double> parse_bytes(std::string_view text);

/// Returns "17.6 GB".
std::string bytes_text(double bytes);

/// Limits this process to so many bytes more than it has; 0: to three quarters of the machine's
/// memory, or of the limit of the process's control group.
void limit_memory(double bytes);

/// Returns the bytes that the process can have: the machine's memory and swap, or the least limit
/// set for it by limit_memory() or by others.
double memory_limit();

}  // namespace etalon
