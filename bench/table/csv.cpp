#include "bench/table/csv.h"

namespace etalon::table {
namespace {

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
    std::string text(1, '"');
    for (const char c : field) {
        if (c == '"') text += c;
        text += c;
    }
    return text += '"';
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        line += quoted(fields[i]) + (i + 1 < fields.size() ? "," : "\r\n");
    }
    return line;
}

}  // namespace etalon::table
