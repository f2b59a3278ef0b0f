#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"

namespace etalon {

/// Diagnostics in the order in which they were found. Those beyond the limit of a kind and
/// severity are only counted, so that a million of them cost neither time nor memory, and that
/// warnings hide no error.
class DiagnosticList {
  public:
    /// Returns a new diagnostic without place and message, or null if there are enough of the
    /// kind and severity. It is valid until the next call.
    Diagnostic* admit(Severity severity, std::string_view kind);

    /// Returns whether further ones of the kind and severity are only counted.
    bool is_full(Severity severity, std::string_view kind) const;

    /// Appends another list, leaving it empty.
    void append(DiagnosticList& other);

    bool has_errors() const { return has_errors_; }
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }

  private:
    struct Kind {
        bool is(Severity s, std::string_view kind) const { return severity == s && name == kind; }

        Severity severity;
        std::string_view name;
        int kept;
        std::size_t last;  ///< last of those kept
    };

    bool has_errors_ = false;
    std::vector<Kind> kinds_;
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace etalon
