// Standard output and standard error of the programs: results go to the former, messages to the
// latter. Functions neither throw nor end the program, even if a stream is closed, full or no
// longer read.
#pragma once

#include <fmt/format.h>

#include <exception>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/printable.h"

namespace etalon {

/// Prepares the standard streams; a program must call this first. If the caller closed some of the
/// descriptors 0 to 2, they are occupied by files that can be neither read nor written; otherwise
/// the next file opened, such as an image, would receive the messages. Writing to a pipe without a
/// reader, or beyond the limit of a file's size, becomes an ordinary error.
void prepare_standard_streams();

/// Writes whole lines to standard error, as far as possible; the rest is lost, also if no one reads
/// it for seconds. Each line is made printable().
void write_message(std::string_view text) noexcept;

/// Writes to standard error what the next such line makes obsolete, with what controls the
/// terminal. Does not wait: it is lost if there is no room for it now.
void write_fleeting(std::string_view line) noexcept;

/// Stores messages from now on instead of writing them to standard error.
void hold_messages() noexcept;

/// Returns the stored messages.
std::string held_messages();

/// Writes to standard output at once. Returns false if that failed, now or earlier.
bool write_result(std::string_view text) noexcept;
bool write_result(fmt::string_view format, fmt::format_args values) noexcept;

/// Returns a value as it may be shown in a message: texts become printable().
template <class T>
decltype(auto) shown_value(const T& value) {
    if constexpr (std::is_convertible_v<const T&, std::string_view>) {
        return printable(value);
    } else {
        return (value);
    }
}

/// Formats a message for standard error.
template <class... T>
void print_message(fmt::format_string<T...> format, T&&... values) noexcept {
    try {
        [&](const auto&... shown) {
            write_message(fmt::vformat(format, fmt::make_format_args(shown...)));
        }(shown_value(values)...);
    } catch (const std::exception&) {  // out of memory, even for the message
    }
}

/// Formats a message for write_fleeting().
template <class... T>
void print_fleeting(fmt::format_string<T...> format, T&&... values) noexcept {
    try {
        write_fleeting(fmt::format(format, std::forward<T>(values)...));
    } catch (const std::exception&) {  // out of memory
    }
}

/// Formats results for standard output.
template <class... T>
bool print_result(fmt::format_string<T...> format, T&&... values) noexcept {
    return write_result(format, fmt::make_format_args(values...));
}

/// Returns the exit status of a program that would end with `status`. If not all results were
/// written to standard output, prints a message and returns another status.
int status_after_results(const char* program, int status) noexcept;

}  // namespace etalon
