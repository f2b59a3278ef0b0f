#include "core/formats/diagnostic_list.h"

#include <algorithm>
#include <iterator>

namespace etalon {

Diagnostic* DiagnosticList::admit(Severity severity, std::string_view kind) {
    has_errors_ |= severity == Severity::error;
    const auto same = [&](const Kind& k) { return k.is(severity, kind); };
    auto found = std::find_if(kinds_.begin(), kinds_.end(), same);
    if (found == kinds_.end()) found = kinds_.insert(found, Kind{severity, kind, 0, 0});
    if (found->kept == diagnostics_of_a_kind) {
        ++diagnostics_[found->last].more;
        return nullptr;
    }
    ++found->kept;
    found->last = diagnostics_.size();
    diagnostics_.push_back({severity, std::string(kind), {}, 0, 0, {}, 0});
    return &diagnostics_.back();
}

bool DiagnosticList::is_full(Severity severity, std::string_view kind) const {
    return std::ranges::any_of(kinds_, [&](const Kind& k) {
        return k.is(severity, kind) && k.kept == diagnostics_of_a_kind;
    });
}

void DiagnosticList::append(DiagnosticList& other) {
    has_errors_ |= other.has_errors_;
    std::ranges::move(other.diagnostics_, std::back_inserter(diagnostics_));
    other.diagnostics_.clear();
}

}  // namespace etalon
