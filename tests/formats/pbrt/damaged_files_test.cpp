// Truncated files and files with changed bytes: any damage must give consistent frames and
// diagnostics.
#include "core/numerics/random.h"
#include "tests/formats/pbrt/pbrt_text.h"
#include "tests/formats/pbrt/whole_files.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

bool is_number(std::uint32_t number, std::size_t size) {
    return number == none || number < size;
}

/// Returns whether all names in the parameters are defined in the frame.
bool is_bound(const Plugin& plugin, const Frame& frame) {
    return std::ranges::all_of(plugin.parameters.arguments(), [&](const Argument& a) {
        const auto* texture = std::get_if<TextureNumber>(&a.values);
        return !texture || texture->number < frame.textures.size();
    });
}

bool is_bound(const Shape& shape, const Frame& frame) {
    return is_bound(shape.plugin, frame) && shape.material < frame.materials.size() &&
           is_number(shape.area_light, frame.area_lights.size()) &&
           is_number(shape.media.inside, frame.media.size()) &&
           is_number(shape.media.outside, frame.media.size()) &&
           shape.to_world.start < frame.transforms.size() &&
           shape.to_world.end < frame.transforms.size();
}

void check_frame(const Frame& frame) {
    for (std::uint32_t i = 0; i < frame.transforms.size(); ++i) {
        CHECK(is_finite(frame.transforms[i]));
    }
    for (const Shape& shape : frame.shapes) CHECK(is_bound(shape, frame));
    for (const Object& object : frame.objects) {
        for (const Shape& shape : object.shapes) CHECK(is_bound(shape, frame));
    }
    for (const Instance& instance : frame.instances) {
        CHECK(instance.object < frame.objects.size());
        CHECK(instance.to_world.end < frame.transforms.size());
    }
    for (const Material& material : frame.materials) {
        CHECK(is_bound(material.plugin, frame));
        for (const std::uint32_t mixed : material.mixed) {
            CHECK(is_number(mixed, frame.materials.size()));
        }
    }
    for (const Texture& texture : frame.textures) CHECK(is_bound(texture.plugin, frame));
    CHECK(is_number(frame.camera_medium, frame.media.size()));
}

void check_survives(const std::string& text) {
    CAPTURE(text);
    const ParsedFile file = parse_text(text);
    CHECK(file.diagnostics.size() <= 200);
    for (const Diagnostic& d : file.diagnostics) {
        CHECK_FALSE(d.message.empty());
        CHECK_FALSE(d.file.empty());
    }
    for (const Frame& frame : file.frames) check_frame(frame);
    if (file.frames.empty()) CHECK_FALSE(file.diagnostics.empty());
}

}  // namespace

TEST_CASE("the files to be damaged are whole") {
    CHECK(messages(parse_text(whole_files()[0])) == Messages{});
    CHECK_FALSE(parse_text(whole_files()[1]).is_fatal);
    CHECK(parse_text(whole_files()[1]).frames.size() == 2);
    for (const std::string& scene : whole_files()) check_survives(scene);
}

TEST_CASE("a PBRT file truncated anywhere gives its complete statements, and a diagnostic") {
    for (const std::string& scene : whole_files()) {
        for (std::size_t size = 0; size < scene.size(); ++size) {
            const std::string text = scene.substr(0, size);
            check_survives(text);
            if (text.find("WorldEnd") == std::string::npos) {
                CHECK_FALSE(parse_text(text).diagnostics.empty());
            }
        }
    }
}

TEST_CASE("a PBRT file with bytes flipped gives frames that hold together") {
    Random random(7);
    for (const std::string& scene : whole_files()) {
        for (int i = 0; i < 2000; ++i) {
            std::string damaged = scene;
            for (std::size_t k = 0; k <= random.index(3); ++k) {
                damaged[random.index(damaged.size())] = static_cast<char>(random.index(256));
            }
            check_survives(damaged);
        }
    }
}

TEST_CASE("a PBRT file with words exchanged gives frames that hold together") {
    Random random(8);
    for (const std::string& scene : whole_files()) {
        std::vector<std::string> words;
        for (std::size_t at = 0; at < scene.size();) {
            const std::size_t end = std::min(scene.find_first_of(" \n", at), scene.size());
            if (end > at) words.push_back(scene.substr(at, end - at));
            at = end + 1;
        }
        for (int i = 0; i < 2000; ++i) {
            std::vector<std::string> shuffled = words;
            for (int k = 0; k < 3; ++k) {
                std::swap(shuffled[random.index(words.size())],
                          shuffled[random.index(words.size())]);
            }
            std::string text;
            for (const std::string& word : shuffled) text += word + " ";
            check_survives(text);
        }
    }
}
