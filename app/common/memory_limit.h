// How much memory the programs may take: what they ask for beyond it fails, and they say so, where
// without a limit the system would end them, or others, without a word.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace etalon {

/// Returns the bytes of "500M", "4 GB" or "1.5GiB" (K, M, G, T: powers of 1000; with i, of 1024);
/// nothing for what is no size.
std::optional<double> parse_bytes(std::string_view text);

/// Returns "17.6 GB".
std::string bytes_text(double bytes);

/// Lets this process take so many bytes more than it has; 0: three quarters of the machine's
/// memory, or of what the process's control group may have.
void limit_memory(double bytes);

/// Returns the bytes that the process can have: the machine's memory and swap, or the least limit
/// set for it, be it by limit_memory() or by others.
double memory_limit();

}  // namespace etalon
