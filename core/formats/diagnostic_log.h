#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/diagnostic_list.h"
#include "core/formats/locator.h"

namespace etalon {

/// Collects the diagnostics about one text. Places are byte offsets.
class DiagnosticLog {
  public:
    /// `text` must outlive the log. In a strict log warnings are errors.
    DiagnosticLog(std::string file, std::string_view text, bool strict)
        : file_(std::move(file)), locator_(text), strict_(strict) {}

    template <class... T>
    void warn(std::size_t offset, std::string_view kind, fmt::format_string<T...> text,
              T&&... arguments) {
        add(strict_ ? Severity::error : Severity::warning, offset, kind, text,
            std::forward<T>(arguments)...);
    }

    template <class... T>
    void error(std::size_t offset, std::string_view kind, fmt::format_string<T...> text,
               T&&... arguments) {
        add(Severity::error, offset, kind, text, std::forward<T>(arguments)...);
    }

    /// Appends the diagnostics about another file that this one refers to.
    void append(DiagnosticLog& other) { list_.append(other.list_); }

    /// Offset of messages about the file as a whole.
    static constexpr std::size_t whole_file = std::string_view::npos;

    DiagnosticList& list() { return list_; }
    bool has_errors() const { return list_.has_errors(); }
    std::vector<Diagnostic> take() { return list_.take(); }

  private:
    template <class... T>
    void add(Severity severity, std::size_t offset, std::string_view kind,
             fmt::format_string<T...> text, T&&... arguments) {
        if (Diagnostic* d = admit(severity, offset, kind)) {
            d->message = fmt::format(text, std::forward<T>(arguments)...);
        }
    }

    /// Returns a new diagnostic without its message, or null if there are enough of the kind.
    Diagnostic* admit(Severity severity, std::size_t offset, std::string_view kind);

    std::string file_;
    Locator locator_;
    bool strict_;
    DiagnosticList list_;
};

/// Returns a word of a file for use in a message: in quotes, without bytes that are not printable
/// ASCII, and not too long.
std::string in_quotes(std::string_view word);

/// Returns the path of a file for use in a message: in quotes, printable, and whole, since the end
/// says which file it is.
std::string path_in_quotes(std::string_view path);

}  // namespace etalon
