#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/diagnostic_list.h"
#include "core/formats/pbrt/file_loc.h"

namespace etalon::pbrt {

/// Collects the diagnostics about a file and all files that it includes.
class Log {
  public:
    /// In a strict log warnings are errors.
    explicit Log(bool strict) : strict_(strict) {}

    /// Returns the number of a file in places.
    std::uint32_t add_file(const std::string& name);

    template <class... T>
    void warn(FileLoc loc, std::string_view kind, fmt::format_string<T...> text, T&&... values) {
        add(strict_ ? Severity::error : Severity::warning, loc, kind, text,
            std::forward<T>(values)...);
    }

    template <class... T>
    void error(FileLoc loc, std::string_view kind, fmt::format_string<T...> text, T&&... values) {
        add(Severity::error, loc, kind, text, std::forward<T>(values)...);
    }

    /// Reports an error at which pbrt-v3 stops.
    template <class... T>
    void fatal(FileLoc loc, std::string_view kind, fmt::format_string<T...> text, T&&... values) {
        is_fatal_ = true;
        error(loc, kind, text, std::forward<T>(values)...);
    }

    /// Returns what `make` makes, texts which may be expensive, if a message of the kind and
    /// severity would be shown; else empty ones.
    template <class Make>
    auto hint(Severity severity, std::string_view kind, Make make) const {
        using Texts = decltype(make());
        return list_.is_full(strict_ ? Severity::error : severity, kind) ? Texts() : make();
    }

    /// Appends the diagnostics about a file that is not PBRT.
    void append(DiagnosticList& other) { list_.append(other); }

    bool is_strict() const { return strict_; }
    bool is_fatal() const { return is_fatal_; }
    std::vector<Diagnostic> take() { return list_.take(); }
    std::vector<std::string> take_files() { return std::move(files_); }

  private:
    template <class... T>
    void add(Severity severity, FileLoc loc, std::string_view kind, fmt::format_string<T...> text,
             T&&... values) {
        if (Diagnostic* d = list_.admit(severity, kind)) {
            d->file = files_[loc.file];
            d->line = loc.line;
            d->column = loc.column;
            d->message = fmt::format(text, std::forward<T>(values)...);
        }
    }

    DiagnosticList list_;
    std::vector<std::string> files_;
    bool strict_;
    bool is_fatal_ = false;
};

}  // namespace etalon::pbrt
