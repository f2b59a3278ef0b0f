#include "app/common/console.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <exception>
#include <mutex>

#include "app/common/exit_status.h"
#include "core/base/uninterrupted.h"

namespace etalon {
namespace {

/// errno of the first failure to write to standard output; 0 if there was none.
int result_failure = 0;

/// Messages that are stored instead of written.
struct HeldMessages {
    std::atomic<bool> is_on = false;
    std::mutex mutex;
    std::string text;
};
HeldMessages held;

/// Stores a message, as far as memory allows.
void hold(std::string_view text) noexcept {
    try {
        const std::lock_guard lock(held.mutex);
        held.text += text;
    } catch (const std::exception&) {
    }
}

/// Writes to standard error as long as it takes more within so many milliseconds: a pipe that no
/// one reads, or a terminal that was stopped, would take no more for ever. Returns whether it did.
bool write_within(int patience, std::string_view text) noexcept {
    // Where there is room at all, there is room for this much.
    const std::size_t most = ::isatty(STDERR_FILENO) != 0 ? 128 : PIPE_BUF;
    while (!text.empty()) {
        pollfd stream = {STDERR_FILENO, POLLOUT, 0};
        if (uninterrupted([&] { return ::poll(&stream, 1, patience); }) == 0) return false;
        const std::string_view piece = text.substr(0, most);
        if (write_all(STDERR_FILENO, piece) != 0) break;
        text.remove_prefix(piece.size());
    }
    return true;
}

/// Held while lines are written to standard error, which long ones are in pieces.
std::mutex writing;

/// Writes a message to standard error. Once one had to be dropped, the others are not waited for.
void write_patiently(std::string_view text) noexcept {
    constexpr int patience = 2000;
    static std::atomic<bool> was_stuck = false;
    const std::lock_guard lock(writing);
    if (!write_within(was_stuck ? 0 : patience, text)) was_stuck = true;
}

void note_failure(Errno failure) {
    if (result_failure == 0) result_failure = failure;
}

bool is_printable_lines(std::string_view text) {
    return std::ranges::none_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < ' ' && c != '\n') || byte == 0x7F || byte == 0xC2;
    });
}

std::string printable_lines(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        lines += printable(line);
        text.remove_prefix(line.size());
        if (text.empty()) break;
        lines += '\n';
        text.remove_prefix(1);
    }
    return lines;
}

std::string_view view_of(const fmt::memory_buffer& text) {
    return {text.data(), text.size()};
}

}  // namespace

void prepare_standard_streams() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        // A directory always exists, and gets the lowest free descriptor.
        if (::open("/", O_RDONLY | O_DIRECTORY) < 0) return;
    }
}

void hold_messages() noexcept {
    held.is_on = true;
}

std::string held_messages() {
    const std::lock_guard lock(held.mutex);
    return held.text;
}

void write_message(std::string_view text) noexcept {
    if (held.is_on) return hold(text);
    if (is_printable_lines(text)) {  // needs no memory, which may have run out
        write_patiently(text);
        return;
    }
    try {
        write_patiently(printable_lines(text));
    } catch (const std::exception&) {  // out of memory, even for the message
    }
}

void write_fleeting(std::string_view line) noexcept {
    if (held.is_on) return;
    const std::unique_lock lock(writing, std::try_to_lock);
    if (lock) write_within(0, line);
}

bool write_result(std::string_view text) noexcept {
    note_failure(write_all(STDOUT_FILENO, text));
    return result_failure == 0;
}

bool write_result(fmt::string_view format, fmt::format_args values) noexcept {
    try {
        fmt::memory_buffer text;
        fmt::vformat_to(fmt::appender(text), format, values);
        return write_result(view_of(text));
    } catch (const std::exception&) {
        note_failure(ENOMEM);
        return false;
    }
}

int status_after_results(const char* program, int status) noexcept {
    if (result_failure == 0) return status;
    print_message("{}: error: standard output: cannot be written: {}\n", program,
                  error_text(result_failure));
    return status == exit_done || status == exit_differs ? exit_not_written : status;
}

}  // namespace etalon
