#include "core/formats/diagnostic_log.h"

#include "core/base/printable.h"

namespace etalon {

Diagnostic* DiagnosticLog::admit(Severity severity, std::size_t offset, std::string_view kind) {
    Diagnostic* const d = list_.admit(severity, kind);
    if (!d) return nullptr;
    const TextPosition place = offset == whole_file ? TextPosition{0, 0} : locator_.locate(offset);
    d->file = file_;
    d->line = place.line;
    d->column = place.column;
    return d;
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "'";
    for (const char c : word.substr(0, longest)) {
        if (c >= ' ' && c <= '~') {
            text += c;
        } else {
            text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        }
    }
    return text + (word.size() > longest ? "...'" : "'");
}

std::string path_in_quotes(std::string_view path) {
    constexpr std::size_t longest = 4096;  // of the paths that a file can have
    return "'" + printable(path, longest) + "'";
}

}  // namespace etalon
