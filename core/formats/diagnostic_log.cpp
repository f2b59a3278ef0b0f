#include "core/formats/diagnostic_log.h"

#include <algorithm>
#include <iterator>

namespace etalon {

Diagnostic* DiagnosticLog::admit(Severity severity, std::size_t offset, std::string_view kind) {
    has_errors_ |= severity == Severity::error;
    const auto same = [&](const Kind& k) { return k.name == kind; };
    auto found = std::find_if(kinds_.begin(), kinds_.end(), same);
    if (found == kinds_.end()) found = kinds_.insert(found, Kind{kind, 0, 0});
    if (found->kept == diagnostics_of_a_kind) {
        ++diagnostics_[found->last].more;
        return nullptr;
    }
    ++found->kept;
    found->last = diagnostics_.size();
    const TextPosition place = offset == whole_file ? TextPosition{0, 0} : locator_.locate(offset);
    diagnostics_.push_back({severity, std::string(kind), file_, place.line, place.column, {}, 0});
    return &diagnostics_.back();
}

void DiagnosticLog::append(DiagnosticLog& other) {
    has_errors_ |= other.has_errors_;
    std::ranges::move(other.diagnostics_, std::back_inserter(diagnostics_));
    other.diagnostics_.clear();
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "'";
    for (const char c : word.substr(0, longest)) {
        if (c > ' ' && c <= '~') {
            text += c;
        } else {
            text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        }
    }
    return text + (word.size() > longest ? "...'" : "'");
}

}  // namespace etalon
