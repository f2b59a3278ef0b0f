#include "core/formats/camera_block.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/formats/nearest_name.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

constexpr std::int64_t largest_side = 65536;

struct Line {
    std::string_view name, old_name;
    int numbers;
    bool needed;
    void (*read)(Reader&, CameraBlock&);
};

void read_eye(Reader& in, CameraBlock& b) {
    b.camera.eye = in.vector("eye");
}
constexpr Line at{"at", "at", 3, true,
                  [](Reader& in, CameraBlock& b) { b.camera.at = in.vector("at"); }};
constexpr Line up{"up", "up", 3, true,
                  [](Reader& in, CameraBlock& b) { b.camera.up = in.vector("up"); }};
constexpr Line angle{"angle", "angle", 1, true,
                     [](Reader& in, CameraBlock& b) { b.camera.fov_degrees = in.number("angle"); }};
constexpr Line hither{"hither", "hither", 1, false,  // of no effect
                      [](Reader& in, CameraBlock&) { in.number("hither"); }};
constexpr Line resolution{"resolution", "resolution", 2, true, read_resolution};
constexpr Line aperture{"aperture", "aperture", 1, false, [](Reader& in, CameraBlock& b) {
                            b.camera.aperture = in.number("aperture");
                        }};
constexpr Line focal{"focal", "focal", 1, false,
                     [](Reader& in, CameraBlock& b) { b.camera.focal = in.number("focal"); }};

// In the order of the formats' documents; files may have another.
constexpr std::array nff_lines = {
    Line{"from", "from", 3, true, read_eye}, at, up, angle, hither, resolution};
constexpr std::array p3f_lines = {
    Line{"eye", "from", 3, true, read_eye}, at, up, angle, hither, resolution, aperture, focal};

constexpr std::size_t most_lines = std::max(nff_lines.size(), p3f_lines.size());

int numbers_ahead(Tokenizer tokens) {
    int count = 0;
    for (; tokens.at_number() && count <= 3; ++count) tokens.next();
    return count;
}

/// Reads the lines up to the next keyword.
class BlockReader {
  public:
    BlockReader(Reader& in, std::span<const Line> lines) : in_(in), lines_(lines) {}

    CameraBlock read() {
        CameraBlock block{in_.start()};
        while (!ends()) read_line(block);
        return block;
    }

    std::string missing() const {
        std::vector<std::string_view> names;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (lines_[k].needed && !given_[k]) names.push_back(lines_[k].name);
        }
        return fmt::format("{}", fmt::join(names, ", "));
    }

  private:
    bool ends() const { return in_.tokens().at_end() || in_.at_keyword(); }

    const Line* find(std::string_view word) const {
        const auto named = [&](const Line& l) { return l.name == word || l.old_name == word; };
        const auto line = std::ranges::find_if(lines_, named);
        return line != lines_.end() ? &*line : nullptr;
    }

    bool& given(const Line& line) { return given_[static_cast<std::size_t>(&line - &lines_[0])]; }

    /// Returns the first line that has not been read yet.
    const Line* due() const {
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            if (!given_[k]) return &lines_[k];
        }
        return nullptr;
    }

    void read_line(CameraBlock& block) {
        const std::size_t offset = in_.tokens().offset();
        const Line* const line = line_of(in_.tokens().next(), offset);
        if (line) line->read(in_, block);
        if (line && in_.ok()) {
            given(*line) = true;
        } else {
            while (!ends() && !find(in_.tokens().peek())) in_.tokens().next();
        }
        in_.recover();
    }

    /// Returns the line that the word just read begins. The programs of P3F's course accept any
    /// word for the next line; so does this, if the right number of numbers follows.
    const Line* line_of(std::string_view word, std::size_t offset) {
        if (const Line* const line = find(word)) {
            if (given(*line)) {
                in_.warn_at(offset, "camera", "a second '{}'; it replaces the first", word);
            }
            return line;
        }
        const Line* const next = due();
        const bool is_number = Tokenizer(word).at_number();
        if (!is_number && next && numbers_ahead(in_.tokens()) == next->numbers) {
            in_.warn_at(offset, "camera", "expected '{}', found {}; read as '{}'", next->name,
                        in_quotes(word), next->name);
            return next;
        }
        in_.warn_at(offset, "camera", "{} is not part of a camera{}", in_quotes(word),
                    did_you_mean(word, names()));
        return nullptr;
    }

    std::vector<std::string_view> names() const {
        std::vector<std::string_view> list;
        for (const Line& line : lines_) list.push_back(line.name);
        return list;
    }

    Reader& in_;
    std::span<const Line> lines_;
    std::array<bool, most_lines> given_{};  ///< lines that the block has had so far
};

/// Returns why nothing can be seen with this camera, or an empty string.
std::string check_camera(const CameraBlock& b) {
    const Vec3 view = b.camera.eye - b.camera.at;
    const double distance = max_abs(view), fov = b.camera.fov_degrees;
    if (std::min(b.width, b.height) < 1 || std::max(b.width, b.height) > largest_side) {
        return fmt::format("the resolution is {} x {}; expected 1 to {} pixels a side", b.width,
                           b.height, largest_side);
    }
    if (!(fov > 0 && fov < 180)) {
        return fmt::format("the angle is {}; expected more than 0 and less than 180", fov);
    }
    if (view == Vec3(0)) return "the camera's eye is the point it looks at";
    if (!(distance >= least_camera_distance && distance <= largest_camera_distance)) {
        return fmt::format("the camera's eye is {} from the point it looks at; expected {} to {}",
                           distance, least_camera_distance, largest_camera_distance);
    }
    if (to_unit_magnitude(b.camera.up).cross(view) == Vec3(0)) return "'up' is along the view";
    return {};
}

/// Replaces an unusable lens by a pinhole.
void check_lens(Reader& in, Camera& c) {
    if (c.aperture < 0 || (c.aperture > 0 && !(c.focal > 0))) {
        in.warn("camera", "aperture {} with focal {} is not a lens; taken as a pinhole", c.aperture,
                c.focal);
        c.aperture = 0;
    }
}

void skip_camera(SceneLoader& loader, std::size_t start, std::string why) {
    if (loader.unusable_camera) {
        loader.in.warn_at(start, "camera", "{}; this camera is left out", why);
    } else {
        loader.unusable_camera = {start, std::move(why)};
    }
}

}  // namespace

void read_resolution(Reader& in, CameraBlock& b) {
    b.width = in.integer("resolution");
    b.height = in.integer("resolution");
}

void finalize_camera(SceneLoader& loader, CameraBlock block, const std::string& missing) {
    std::string why = missing.empty() ? check_camera(block) : "the camera has no " + missing;
    if (!why.empty()) return skip_camera(loader, block.start, std::move(why));
    Reader& in = loader.in;
    if (loader.has_camera) in.warn("camera", "a second camera; it replaces the first");
    check_lens(in, block.camera);
    loader.scene.camera = block.camera;
    loader.settings.resolution = {static_cast<int>(block.width), static_cast<int>(block.height)};
    loader.has_camera = true;
}

void read_camera_block(SceneLoader& loader, CameraDialect dialect) {
    using Lines = std::span<const Line>;
    BlockReader reader(loader.in, dialect == CameraDialect::nff ? Lines(nff_lines) : p3f_lines);
    const CameraBlock block = reader.read();
    finalize_camera(loader, block, reader.missing());
}

}  // namespace etalon
