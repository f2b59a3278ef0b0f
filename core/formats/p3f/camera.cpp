// camera and the old dialect's v: a block of lines that each start with a word of their own.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/formats/nearest_name.h"
#include "core/formats/p3f/degenerate.h"
#include "core/formats/p3f/keywords.h"

namespace etalon::p3f {
namespace {

constexpr std::int64_t largest_side = 65536;

/// A camera half read.
struct Block {
    Camera camera{};
    std::int64_t width = 0, height = 0;
};

struct Line {
    std::string_view name, old_name;
    int numbers;
    bool needed;
    void (*read)(Reader&, Block&);
};

void read_resolution(Reader& in, Block& b) {
    b.width = in.integer("resolution");
    b.height = in.integer("resolution");
}

/// In the order of the format's document; files may have another. `hither` has no effect.
constexpr std::array lines = {
    Line{"eye", "from", 3, true, [](Reader& in, Block& b) { b.camera.eye = in.vector("eye"); }},
    Line{"at", "at", 3, true, [](Reader& in, Block& b) { b.camera.at = in.vector("at"); }},
    Line{"up", "up", 3, true, [](Reader& in, Block& b) { b.camera.up = in.vector("up"); }},
    Line{"angle", "angle", 1, true,
         [](Reader& in, Block& b) { b.camera.fov_degrees = in.number("angle"); }},
    Line{"hither", "hither", 1, false, [](Reader& in, Block&) { in.number("hither"); }},
    Line{"resolution", "resolution", 2, true, read_resolution},
    Line{"aperture", "aperture", 1, false,
         [](Reader& in, Block& b) { b.camera.aperture = in.number("aperture"); }},
    Line{"focal", "focal", 1, false,
         [](Reader& in, Block& b) { b.camera.focal = in.number("focal"); }},
};

constexpr std::size_t no_line = lines.size();

constexpr auto line_names = [] {
    std::array<std::string_view, lines.size()> result;
    for (std::size_t i = 0; i < lines.size(); ++i) result[i] = lines[i].name;
    return result;
}();

/// Which lines the block has had so far.
using Given = std::array<bool, lines.size()>;

std::size_t find_line(std::string_view word) {
    const auto named = [&](const Line& l) { return l.name == word || l.old_name == word; };
    return static_cast<std::size_t>(std::ranges::find_if(lines, named) - lines.begin());
}

bool block_ends(const Reader& in) {
    return in.tokens().at_end() || find_handler(in.tokens().peek());
}

void skip_to_line(Reader& in) {
    while (!block_ends(in) && find_line(in.tokens().peek()) == no_line) in.tokens().next();
}

int numbers_ahead(Tokenizer tokens) {
    int count = 0;
    for (; tokens.at_number() && count <= 3; ++count) tokens.next();
    return count;
}

/// Which line the word just read opens. The course's programs take any word for the one that is
/// due; so does this, if the right number of numbers follows.
std::size_t line_of(Reader& in, std::string_view word, std::size_t offset, const Given& given) {
    if (const std::size_t k = find_line(word); k != no_line) {
        if (given[k]) in.warn_at(offset, "camera", "a second '{}'; it replaces the first", word);
        return k;
    }
    const auto due = static_cast<std::size_t>(std::ranges::find(given, false) - given.begin());
    const bool word_is_number = Tokenizer(word).at_number();
    if (!word_is_number && due != no_line && numbers_ahead(in.tokens()) == lines[due].numbers) {
        in.warn_at(offset, "camera", "expected '{}', found {}; read as '{}'", lines[due].name,
                   in_quotes(word), lines[due].name);
        return due;
    }
    in.warn_at(offset, "camera", "{} is no part of a camera{}", in_quotes(word),
               did_you_mean(word, line_names));
    return no_line;
}

void read_line(Reader& in, Block& block, Given& given) {
    const std::size_t offset = in.tokens().offset();
    const std::size_t k = line_of(in, in.tokens().next(), offset, given);
    if (k != no_line) lines[k].read(in, block);
    if (k != no_line && in.ok()) {
        given[k] = true;
    } else {
        skip_to_line(in);
    }
    in.recover();
}

std::string missing_lines(const Given& given) {
    std::vector<std::string_view> missing;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (lines[k].needed && !given[k]) missing.push_back(lines[k].name);
    }
    return fmt::format("{}", fmt::join(missing, ", "));
}

/// Why nothing can be seen with this camera, or an empty string.
std::string obstacle(const Block& b, const Given& given) {
    const Vec3 view = to_unit_magnitude(b.camera.eye - b.camera.at);
    const double angle = b.camera.fov_degrees;
    if (const std::string missing = missing_lines(given); !missing.empty()) {
        return fmt::format("the camera has no {}", missing);
    }
    if (std::min(b.width, b.height) < 1 || std::max(b.width, b.height) > largest_side) {
        return fmt::format("the resolution is {} x {}; expected 1 to {} pixels a side", b.width,
                           b.height, largest_side);
    }
    if (!(angle > 0 && angle < 180)) {
        return fmt::format("the angle is {}; expected more than 0 and less than 180", angle);
    }
    if (view == Vec3(0)) return "the camera's eye is the point it looks at";
    if (to_unit_magnitude(b.camera.up).cross(view) == Vec3(0)) return "'up' is along the view";
    return {};
}

/// A lens that is none becomes a pinhole.
void check_lens(Reader& in, Camera& c) {
    if (c.aperture < 0 || (c.aperture > 0 && !(c.focal > 0))) {
        in.warn("camera", "aperture {} with focal {} is no lens; taken as a pinhole", c.aperture,
                c.focal);
        c.aperture = 0;
    }
}

void leave_out(Loader& loader, std::string why) {
    if (loader.unusable_camera) {
        loader.in.warn("camera", "{}; this camera is left out", why);
    } else {
        loader.unusable_camera = {loader.in.start(), std::move(why)};
    }
}

}  // namespace

void read_camera(Loader& loader) {
    Reader& in = loader.in;
    Block block;
    Given given{};
    while (!block_ends(in)) read_line(in, block, given);
    if (std::string why = obstacle(block, given); !why.empty()) {
        return leave_out(loader, std::move(why));
    }
    if (loader.has_camera) in.warn("camera", "a second camera; it replaces the first");
    check_lens(in, block.camera);
    block.camera.width = static_cast<int>(block.width);
    block.camera.height = static_cast<int>(block.height);
    loader.scene.camera = block.camera;
    loader.has_camera = true;
}

}  // namespace etalon::p3f
