// Standard output and standard error of the programs: results go to the one, messages to the other.
// Neither throws nor ends the program, whatever is closed, full or no longer read.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace etalon {

/// Prepares the standard streams; the first thing a program does. Descriptors 0 to 2 that the
/// caller closed are occupied by what can be neither read nor written, or the next file opened, an
/// image say, would receive the messages. Writing to a pipe that nobody reads any more becomes an
/// error like others.
void prepare_standard_streams();

/// Writes to standard error, as far as that can be written; the rest is lost.
void write_message(std::string_view text) noexcept;
void write_message(fmt::string_view format, fmt::format_args values) noexcept;

/// Keeps messages from now on, rather than write them to standard error.
void hold_messages() noexcept;

/// The messages that were kept.
std::string held_messages();

/// Writes to standard output at once. False if that failed, now or earlier.
bool write_result(std::string_view text) noexcept;
bool write_result(fmt::string_view format, fmt::format_args values) noexcept;

/// Formats a message for standard error.
template <class... T>
void print_message(fmt::format_string<T...> format, T&&... values) noexcept {
    write_message(format, fmt::make_format_args(values...));
}

/// Formats results for standard output.
template <class... T>
bool print_result(fmt::format_string<T...> format, T&&... values) noexcept {
    return write_result(format, fmt::make_format_args(values...));
}

/// Returns the exit status of a program that would end with `status`: another one, and a message,
/// if not all of its results were written to standard output.
int status_after_results(const char* program, int status) noexcept;

}  // namespace etalon
