#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/formats/diagnostic.h"

namespace etalon {

/// Diagnostics in the order in which they were found. Those beyond the limit of a kind are only
/// counted, so that a million of them cost neither time nor memory.
class DiagnosticList {
  public:
    /// Returns a new diagnostic without place and message, or null if there are enough of the
    /// kind. It is valid until the next call.
    Diagnostic* admit(Severity severity, std::string_view kind);

    /// Returns whether further ones of the kind are only counted.
    bool is_full(std::string_view kind) const;

    /// Appends another list, leaving it empty.
    void append(DiagnosticList& other);

    bool has_errors() const { return has_errors_; }
    std::vector<Diagnostic> take() { return std::move(diagnostics_); }

  private:
    struct Kind {
        std::string_view name;
        int kept;
        std::size_t last;  ///< last of those kept
    };

    bool has_errors_ = false;
    std::vector<Kind> kinds_;
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace etalon
