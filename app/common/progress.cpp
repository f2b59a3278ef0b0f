#include "app/common/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "app/common/console.h"
#include "app/common/progress_line.h"

namespace etalon {
namespace {

using namespace std::chrono_literals;

constexpr auto terminal_interval = 100ms;
constexpr auto line_interval = 5s;
constexpr int usual_columns = 80;

double seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

/// Returns the columns of the terminal at standard error, minus one: some wrap after the last.
int columns() {
    winsize size = {};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return (known ? size.ws_col : usual_columns) - 1;
}

/// Returns whether standard error is a terminal on which a line can be written over.
bool can_rewrite_lines() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
}

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(can_rewrite_lines()), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
    if (terminal_ && printed_) write_fleeting("\r\x1b[K");
}

void Progress::update(double part) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return;  // another thread is printing
    const Clock::time_point now = Clock::now();
    if (now - last_ < (terminal_ ? Clock::duration(terminal_interval) : line_interval)) return;
    last_ = now;
    printed_ = true;
    print(part, now);
}

void Progress::print(double part, Clock::time_point now) {
    const double elapsed = seconds(now - start_);
    if (terminal_) {
        return print_fleeting("\r{}\x1b[K", progress_line(what_, part, elapsed, columns()));
    }
    const double left = part > 0 ? elapsed * (1 - part) / part : 0;
    print_fleeting("{}: {:.0f} %, {:.1f} s, {:.0f} s left\n", printable(what_), 100 * part, elapsed,
                   left);
}

}  // namespace etalon
