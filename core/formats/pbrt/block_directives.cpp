// Statements that begin and end blocks: the world, attributes, objects, included files.
#include "core/formats/diagnostic_log.h"
#include "core/formats/load.h"
#include "core/formats/pbrt/parser.h"

namespace etalon::pbrt {
namespace {

void begin_world(Parser& p) {
    p.now.block = Block::world;
    p.now.transform = {};
    p.now.coordinate_systems["world"] = p.now.transform.current;
}

void end_world(Parser& p) {
    // A frame takes more memory than the words that begin and end it.
    if (p.frames.size() == std::size_t{most_frames}) {
        p.log.error(p.in.where(), "frames", "only {} frames are read of one file", most_frames);
        p.now = {};
        return;
    }
    end_frame(p);
}

void begin_attributes(Parser& p) {
    FrameState& now = p.now;
    now.saved_attributes.push_back({now.graphics, now.textures.numbers.begin_block(),
                                    now.textures.spectra.begin_block(), now.materials.begin_block(),
                                    p.in.where()});
    now.saved_transforms.push_back({now.transform, true, p.in.where()});
}

void end_attributes(Parser& p) {
    FrameState& now = p.now;
    if (now.saved_attributes.empty()) {
        p.log.error(p.in.where(), "unmatched", "'{}' ends nothing", p.in.directive());
        return;
    }
    SavedAttributes& saved = now.saved_attributes.back();
    now.graphics = std::move(saved.state);
    now.textures.numbers.end_block(saved.numbers);
    now.textures.spectra.end_block(saved.spectra);
    now.materials.end_block(saved.materials);
    now.saved_attributes.pop_back();
    // None is left if a TransformEnd has ended the block before.
    if (now.saved_transforms.empty()) return;
    if (!now.saved_transforms.back().is_attribute) {
        p.log.warn(p.in.where(), "unmatched", "'{}' ends what 'TransformBegin' began",
                   p.in.directive());
    }
    now.transform = std::move(now.saved_transforms.back().scope);
    now.saved_transforms.pop_back();
}

void reverse_orientation(Parser& p) {
    p.now.graphics.reverse_orientation = !p.now.graphics.reverse_orientation;
}

void begin_object(Parser& p) {
    const std::string name = p.in.string("a name");
    if (!p.in.ok()) return;
    if (p.now.object != none) {
        p.log.error(p.in.where(), "nested",
                    "'ObjectBegin' inside an object: what follows is of "
                    "the new one");
    }
    begin_attributes(p);
    p.now.object = static_cast<std::uint32_t>(p.frame().objects.size());
    p.frame().objects.push_back({name, {}});
    p.now.objects[name] = p.now.object;
}

void end_object(Parser& p) {
    if (p.now.object == none) {
        p.log.error(p.in.where(), "unmatched", "'ObjectEnd' outside of an object");
    }
    p.now.object = none;
    end_attributes(p);
}

void instance_object(Parser& p) {
    const std::string name = p.in.string("a name");
    if (!p.in.ok()) return;
    if (p.now.object != none) {
        p.log.error(p.in.where(), "nested", "'ObjectInstance' inside an object is left out");
        return;
    }
    const auto found = p.now.objects.find(name);
    if (found == p.now.objects.end()) {
        p.log.error(p.in.where(), "undefined", "no object {} is defined", in_quotes(name));
    } else if (!p.frame().objects[found->second].shapes.empty()) {
        p.frame().instances.push_back({found->second, p.transform_pair(), p.in.where()});
    }
}

void include_file(Parser& p) {
    const std::string name = p.in.string("a file");
    if (p.in.ok()) p.tokens.include(name, p.in.where());
}

constexpr auto in_world = Directive::Allowed::in_world;

constexpr std::array directives = {
    Directive{"ObjectInstance", in_world, instance_object},
    Directive{"AttributeBegin", in_world, begin_attributes},
    Directive{"AttributeEnd", in_world, end_attributes},
    Directive{"ObjectBegin", in_world, begin_object},
    Directive{"ObjectEnd", in_world, end_object},
    Directive{"ReverseOrientation", in_world, reverse_orientation},
    Directive{"Include", Directive::Allowed::anywhere, include_file},
    Directive{"WorldBegin", Directive::Allowed::in_options, begin_world},
    Directive{"WorldEnd", in_world, end_world},
};

}  // namespace

std::span<const Directive> block_directives() {
    return directives;
}

void end_frame(Parser& p) {
    FrameState& now = p.now;
    for (const SavedAttributes& open : now.saved_attributes) {
        p.log.warn(open.where, "unmatched", "this block is not ended");
    }
    for (const SavedTransform& open : now.saved_transforms) {
        if (!open.is_attribute) p.log.warn(open.where, "unmatched", "this block is not ended");
    }
    now.frame.camera_medium = p.current_media(now.frame.camera.where).outside;
    p.frames.push_back(std::move(now.frame));
    p.now = {};
}

}  // namespace etalon::pbrt
