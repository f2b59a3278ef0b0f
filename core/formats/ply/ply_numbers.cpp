#include "core/formats/ply/ply_numbers.h"

#include "core/formats/number.h"

namespace etalon::ply {
namespace {

/// Reads a word without digits, such as "nan", as a number; returns false if it is none.
bool read_named(std::string_view word, double& value) {
    const bool minus = word.starts_with('-');
    if (minus || word.starts_with('+')) word.remove_prefix(1);
    std::string lower(word.substr(0, std::string_view("infinity").size() + 1));
    for (char& c : lower) c = static_cast<char>(c | 0x20);
    value = lower == "nan" || lower == "-nan" ? nan_value : minus ? -infinity : infinity;
    return lower == "nan" || lower == "inf" || lower == "infinity";
}

}  // namespace

bool AsciiNumbers::read(Type, double& value) {
    const ScannedNumber scanned = scan_number(next_, last_, value);
    const bool whole = scanned.end == last_ || is_blank(*scanned.end);
    if (scanned.status == NumberStatus::ok && whole) {
        next_ = scanned.end;
    } else if (scanned.status == NumberStatus::out_of_range && whole) {
        value = infinity;
        next_ = scanned.end;
    } else if (read_named(word(), value)) {
        next_ += word().size();
    } else {
        return false;
    }
    skip_blanks();
    return true;
}

std::string AsciiNumbers::error() const {
    return reason_or(next_ == last_ ? "the file ends"
                                    : "expected a number, found " + in_quotes(word()));
}

}  // namespace etalon::ply
