#include "app/common/progress_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace etalon {
namespace {

constexpr std::string_view gap = "...";
constexpr int shortest_task = 8;
constexpr int bar_widths[] = {30, 20, 10};

/// One character of a text in UTF-8.
struct Glyph {
    std::string_view bytes;
    int columns;
};

bool continues_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

std::vector<Glyph> glyphs_of(std::string_view text) {
    std::vector<Glyph> glyphs;
    while (!text.empty()) {
        std::size_t size = 1;
        while (size < text.size() && continues_character(text[size])) ++size;
        const auto lead = static_cast<unsigned char>(text[0]);
        const bool printable = lead >= 0x20 && lead != 0x7F && (lead < 0x80 || size > 1);
        glyphs.push_back({printable ? text.substr(0, size) : "?", size >= 3 ? 2 : 1});
        text.remove_prefix(size);
    }
    return glyphs;
}

int columns_of(const std::vector<Glyph>& glyphs) {
    int columns = 0;
    for (const Glyph& glyph : glyphs) columns += glyph.columns;
    return columns;
}

/// Returns the number of glyphs from `first` on that fit into so many columns.
template <class Iterator>
std::ptrdiff_t fitting(Iterator first, Iterator last, int columns) {
    Iterator end = first;
    while (end != last && (columns -= end->columns) >= 0) ++end;
    return end - first;
}

std::string joined(const std::vector<Glyph>& glyphs, std::ptrdiff_t from, std::ptrdiff_t to) {
    std::string text;
    for (std::ptrdiff_t i = from; i < to; ++i) text += glyphs[static_cast<std::size_t>(i)].bytes;
    return text;
}

/// Returns the widest bar that leaves `columns` for the rest, or none.
std::string bar(double part, int columns) {
    for (const int width : bar_widths) {
        if (width + 3 > columns) continue;
        const int filled = std::clamp(static_cast<int>(part * width), 0, width);
        return fmt::format(" [{:#<{}}{:.<{}}]", "", filled, "", width - filled);
    }
    return {};
}

}  // namespace

std::string shortened(std::string_view text, int columns) {
    const std::vector<Glyph> glyphs = glyphs_of(text);
    const auto count = static_cast<std::ptrdiff_t>(glyphs.size());
    if (columns_of(glyphs) <= columns) return joined(glyphs, 0, count);
    const int room = columns - static_cast<int>(gap.size());
    if (room < 2) return std::string(gap.substr(0, static_cast<std::size_t>(std::max(columns, 0))));
    const std::ptrdiff_t head = fitting(glyphs.begin(), glyphs.end(), room / 3);
    const std::ptrdiff_t tail = fitting(glyphs.rbegin(), glyphs.rend(), room - room / 3);
    return joined(glyphs, 0, head) + std::string(gap) + joined(glyphs, count - tail, count);
}

std::string progress_line(std::string_view task, double part, double seconds, int columns) {
    const double left = part > 0 ? seconds * (1 - part) / part : 0;
    const std::string figures =
        fmt::format(" {:3.0f} %  {:.1f} s, {:.0f} s left", 100 * part, seconds, left);
    const int room = columns - static_cast<int>(figures.size());
    if (room < shortest_task) return shortened(figures, columns);
    const int needed = std::min(columns_of(glyphs_of(task)), room);
    const std::string shown = bar(part, room - std::min(needed, std::max(shortest_task, room / 2)));
    return shortened(task, room - static_cast<int>(shown.size())) + shown + figures;
}

}  // namespace etalon
