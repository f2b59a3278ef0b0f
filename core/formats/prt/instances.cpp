// instance, end_instance and instance_of. An instance is a piece of text: it is read once where it
// is defined, so that its errors are told, and again for every reference, where its objects are
// moved and its surfaces take effect, for what comes after the reference as well.
#include <utility>

#include "core/formats/prt/prt_loader.h"
#include "core/scene/transformed.h"

namespace etalon::prt {
namespace {

/// Limit of the text that is replayed, in bytes: a small file could ask for any amount.
constexpr std::size_t most_replayed = std::size_t{1} << 27;

/// The end of the definition: its objects are no part of the scene. Returns them.
Geometry close(Loader& loader) {
    OpenDefinition& open = *loader.open;
    Geometry objects = std::exchange(loader.scene.geometry, std::move(open.outer_geometry));
    loader.scene.whitted().materials.resize(open.outer_materials);
    loader.material = open.outer_material;
    loader.smooth_vertices = {};
    return objects;
}

void close_definition(Loader& loader) {
    const Geometry objects = close(loader);
    const OpenDefinition open = *std::exchange(loader.open, std::nullopt);
    bool inherits = false;  // whether it has objects of what stands in for a reference's surface
    for (const Primitive p : objects.primitives) inherits |= p.material == open.outer_materials;
    const std::size_t length = loader.in.start() - open.first;
    const Definition definition{loader.text.substr(open.first, length), inherits};
    if (!loader.definitions.emplace(open.name, definition).second) {
        loader.in.warn_at(open.keyword, "instance", "a second instance {}; the first one stays",
                          in_quotes(open.name));
    }
}

/// Reads the statements once more, silently.
void replay(Loader& loader, const Definition& definition, const Vec3& offset) {
    const std::size_t materials = loader.scene.whitted().materials.size();
    const std::optional<std::uint32_t> before = loader.material;
    Geometry scene_geometry = std::exchange(loader.scene.geometry, {});
    DiagnosticLog silent({}, definition.statements, false);
    Loader again{{Reader(definition.statements, silent, object_names()), loader.options,
                  loader.directory, loader.default_material, std::move(loader.scene)},
                 definition.statements};
    again.material = loader.material;
    read_objects(again);
    loader.scene = std::move(again.scene);
    loader.material = again.material;
    const std::optional<Geometry> objects =
        moved(std::exchange(loader.scene.geometry, std::move(scene_geometry)), offset);
    if (objects) {
        append(loader.scene.geometry, *objects);
    } else {
        loader.scene.whitted().materials.resize(materials);
        loader.material = before;
        loader.skip_degenerate("it lies beyond all numbers");
    }
}

}  // namespace

void read_instance(Loader& loader) {
    Reader& in = loader.in;
    const std::string_view name = in.word("name");
    if (!in.ok()) return;
    if (loader.open) {
        ++loader.open->nested;
        return in.error("instance", "an instance inside instance {}", in_quotes(loader.open->name));
    }
    loader.open = {name,
                   in.start(),
                   in.tokens().offset(),
                   0,
                   std::exchange(loader.scene.geometry, {}),
                   loader.scene.whitted().materials.size(),
                   loader.material};
    loader.smooth_vertices = {};
    loader.set_material(loader.default_material);  // stands in for that of a reference
}

void read_end_instance(Loader& loader) {
    if (!loader.open) {
        return loader.in.error("instance", "'end_instance' without an instance to end");
    }
    if (loader.open->nested > 0) {
        --loader.open->nested;
    } else {
        close_definition(loader);
    }
}

void drop_open_definition(Loader& loader) {
    close(loader);
    loader.in.warn_at(loader.open->keyword, "instance", "instance {} has no end; it is left out",
                      in_quotes(loader.open->name));
    loader.open.reset();
}

void read_instance_of(Loader& loader) {
    Reader& in = loader.in;
    const std::string_view name = in.word("name");
    const Vec3 offset = in.vector("offset");
    if (!in.ok()) return;
    if (loader.open) {
        return in.error("instance", "'instance_of' inside instance {}",
                        in_quotes(loader.open->name));
    }
    const auto found = loader.definitions.find(name);
    if (found == loader.definitions.end()) {
        return in.error("instance", "no instance {} is defined above", in_quotes(name));
    }
    const Definition& definition = found->second;
    loader.replayed += definition.statements.size();
    if (loader.replayed > most_replayed) {
        return in.error("instance", "the instances amount to more than {} bytes", most_replayed);
    }
    if (definition.inherits_surface) loader.current_material();
    replay(loader, definition, offset);
}

}  // namespace etalon::prt
