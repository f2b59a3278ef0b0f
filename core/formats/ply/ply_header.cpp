#include "core/formats/ply/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/formats/byte_order_mark.h"

namespace etalon::ply {
namespace {

struct TypeName {
    std::string_view name;
    Type type;
};

constexpr TypeName type_names[] = {
    {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
    {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
    {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
    {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
    {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
    {"float64", Type::float64}};

constexpr std::size_t most_elements = 1000;  // names are compared with all before them

constexpr std::pair<std::string_view, FileFormat> formats[] = {
    {"ascii", FileFormat::ascii},
    {"binary_little_endian", FileFormat::little_endian},
    {"binary_big_endian", FileFormat::big_endian}};

/// The words of a line.
class Line {
  public:
    explicit Line(std::string_view text) : rest_(text) {}

    /// Returns the next word; empty at the end.
    std::string_view next() {
        const std::size_t first = std::min(rest_.find_first_not_of(" \t\r"), rest_.size());
        rest_.remove_prefix(first);
        const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
        rest_.remove_prefix(word.size());
        return word;
    }

  private:
    std::string_view rest_;
};

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, DiagnosticLog& log)
        : bytes_(bytes),
          log_(log),
          line_end_(line_end_of(bytes)),
          next_(byte_order_mark_size(bytes)) {}

    std::optional<Header> read() {
        if (Line(take_line()).next() != "ply") {
            fail("expected 'ply' at the start of a PLY file");
            return std::nullopt;
        }
        while (good_ && !ended_) read_statement();
        if (good_ && !format_) fail("the header does not say a format");
        if (!good_) return std::nullopt;
        return Header{*format_, std::move(elements_), next_};
    }

  private:
    /// Returns CR if the first line ends with it alone, else LF, before which a CR is a blank.
    static char line_end_of(std::string_view bytes) {
        const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
        const std::string_view rest = bytes.substr(end);
        return rest.starts_with('\r') && !rest.starts_with("\r\n") ? '\r' : '\n';
    }

    std::string_view take_line() {
        line_ = next_;
        const std::size_t end = bytes_.find(line_end_, line_);
        next_ = end == bytes_.npos ? bytes_.size() : end + 1;
        return bytes_.substr(line_, next_ - line_ - (end == bytes_.npos ? 0 : 1));
    }

    template <class... T>
    void fail(fmt::format_string<T...> text, T&&... arguments) {
        log_.error(line_, "syntax", text, std::forward<T>(arguments)...);
        good_ = false;
    }

    void read_statement() {
        if (next_ == bytes_.size()) {
            line_ = next_;
            return fail("the file ends before 'end_header'");
        }
        Line line(take_line());
        const std::string_view keyword = line.next();
        if (keyword == "format") return read_format(line);
        if (keyword == "element") return read_element(line);
        if (keyword == "property") return read_property(line);
        if (keyword == "end_header") return void(ended_ = true);
        if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return;
        fail("expected a statement of the header, found {}", in_quotes(keyword));
    }

    void read_format(Line& line) {
        const std::string_view name = line.next();
        for (const auto& [known, format] : formats) {
            if (name == known) format_ = format;
        }
        if (!format_) {
            fail("expected the format ascii, binary_little_endian or binary_big_endian, found {}",
                 in_quotes(name));
        }
    }

    void read_element(Line& line) {
        const std::string_view name = line.next(), count = line.next();
        Element element{name, 0, line_, {}};
        const char* const end = count.data() + count.size();
        const auto [behind, error] = std::from_chars(count.data(), end, element.count);
        if (error != std::errc() || behind != end) {
            return fail("expected the number of elements {}, found {}", in_quotes(name),
                        in_quotes(count));
        }
        const auto same = [&](const Element& e) { return e.name == name; };
        if (std::ranges::any_of(elements_, same)) {
            return fail("there are elements {} already", in_quotes(name));
        }
        if (elements_.size() == most_elements) return fail("too many kinds of elements");
        elements_.push_back(std::move(element));
    }

    Type read_type(Line& line) {
        const std::string_view word = line.next();
        const TypeName* const found = std::ranges::find(type_names, word, &TypeName::name);
        if (found != std::end(type_names)) return found->type;
        fail("expected the type of a number, found {}", in_quotes(word));
        return Type::int8;
    }

    void read_property(Line line) {
        if (elements_.empty()) return fail("a property before the first element");
        Property property{{}, Type::int8, {}};
        if (Line(line).next() == "list") {
            line.next();
            property.count = read_type(line);
            if (*property.count >= Type::float32 && good_) {
                fail("the number of values of a list must be an integer");
            }
        }
        if (good_) property.type = read_type(line);
        property.name = line.next();
        if (good_ && property.name.empty()) fail("a property without a name");
        elements_.back().properties.push_back(property);
    }

    std::string_view bytes_;
    DiagnosticLog& log_;
    char line_end_;
    std::size_t next_, line_ = 0;  ///< starts of the next line and of the current one
    bool good_ = true, ended_ = false;
    std::optional<FileFormat> format_;
    std::vector<Element> elements_;
};

}  // namespace

std::size_t size_of(Type type) {
    static constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::size_t Element::least_bytes() const {
    std::size_t bytes = 0;
    for (const Property& p : properties) bytes += size_of(p.count.value_or(p.type));
    return bytes;
}

bool Element::has_lists() const {
    return std::ranges::any_of(properties, [](const Property& p) { return p.count.has_value(); });
}

const Property* Element::find(std::string_view property, bool list) const {
    const auto found = std::ranges::find_if(properties, [&](const Property& p) {
        return p.name == property && p.count.has_value() == list;
    });
    return found == properties.end() ? nullptr : &*found;
}

const Element* Header::find(std::string_view element) const {
    const auto found = std::ranges::find(elements, element, &Element::name);
    return found == elements.end() ? nullptr : &*found;
}

std::optional<Header> read_header(std::string_view bytes, DiagnosticLog& log) {
    return HeaderReader(bytes, log).read();
}

}  // namespace etalon::ply
