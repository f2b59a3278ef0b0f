#include "app/live/http_request.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace etalon {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Tests for a character of methods and names (RFC 9110, 5.6.2).
bool is_token_character(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_token_character);
}

bool is_target(std::string_view text) {
    return text.starts_with('/') &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 0x7F; });
}

bool is_version(std::string_view text) {
    return text.size() == 8 && text.starts_with("HTTP/1.") && is_digit(text.back());
}

bool is_control(char c) {
    return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == 0x7F;
}

/// Compares a field's name with one in lower case.
bool is_named(std::string_view name, std::string_view lower) {
    const auto is_equal = [](char c, char l) { return (c >= 'A' && c <= 'Z' ? c + 32 : c) == l; };
    return std::equal(name.begin(), name.end(), lower.begin(), lower.end(), is_equal);
}

/// Removes what precedes the separator, or everything, from the text, and returns it.
std::string_view take(std::string_view& text, std::string_view separator) {
    const std::size_t size = std::min(text.find(separator), text.size());
    const std::string_view taken = text.substr(0, size);
    text.remove_prefix(std::min(size + separator.size(), text.size()));
    return taken;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// Returns the size of the head, with the empty line that ends it; 0 if that is missing. Lines that
/// lack a CR count, so that they are refused at once.
std::size_t head_size(std::string_view bytes) {
    const std::size_t proper = bytes.find("\n\r\n"), lone = bytes.find("\n\n");
    if (proper < lone) return proper + 3;
    return lone == std::string_view::npos ? 0 : lone + 2;
}

/// The fields that matter here; others are ignored.
struct Fields {
    std::optional<std::string_view> host, length;
};

/// Returns whether a line is a field, and not a second one of those that matter.
bool read_field(std::string_view line, Fields& fields) {
    if (line.find(':') == std::string_view::npos) return false;
    const std::string_view name = take(line, ":");
    if (!is_token(name) || std::any_of(line.begin(), line.end(), is_control)) return false;
    for (const auto& [known, value] :
         {std::pair("host", &fields.host), std::pair("content-length", &fields.length)}) {
        if (!is_named(name, known)) continue;
        if (*value) return false;
        *value = trimmed(line);
    }
    return true;
}

/// Returns 200 if the length of a body is acceptable.
int status_of_length(std::string_view text) {
    if (text.empty() || !std::all_of(text.begin(), text.end(), is_digit)) return 400;
    std::size_t length = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), length);
    return error != std::errc() || length > largest_http_body ? 413 : 200;
}

}  // namespace

ParsedRequest parse_http_request(std::string_view bytes) {
    const std::size_t size = head_size(bytes);
    if ((size > 0 ? size : bytes.size()) > largest_http_head) return {431, {}};
    if (size == 0) return {0, {}};
    std::string_view head = bytes.substr(0, size);
    std::string_view line = take(head, "\r\n");
    const std::string_view method = take(line, " "), target = take(line, " ");
    if (!is_token(method) || !is_target(target) || !is_version(line)) return {400, {}};
    Fields fields;
    while (!(line = take(head, "\r\n")).empty()) {
        if (!read_field(line, fields)) return {400, {}};
    }
    if (!fields.host) return {400, {}};
    const int status = status_of_length(fields.length.value_or("0"));
    const std::string_view path = target.substr(0, target.find('?'));
    return {status, {std::string(method), std::string(*fields.host), std::string(path)}};
}

}  // namespace etalon
