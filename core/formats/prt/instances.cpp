// instance, end_instance and instance_of. The statements of an instance are read once where it is
// defined, so that their errors are reported, and again for the first reference after each surface
// that its objects can inherit: they make an object, which every such reference instantiates. The
// surfaces take effect at each reference, also for what follows it.
#include <utility>

#include "core/formats/prt/prt_loader.h"
#include "core/scene/transformed.h"

namespace etalon::prt {
namespace {

/// Limit of the text that is read again, in bytes: a small file could ask for any amount.
constexpr std::size_t most_replayed = std::size_t{1} << 27;

/// Ends the definition, whose objects are not part of the scene. Returns them.
Geometry close(Loader& loader) {
    OpenDefinition& open = *loader.open;
    Geometry objects = std::exchange(loader.scene.geometry, std::move(open.outer_geometry));
    loader.scene.whitted().materials.resize(open.outer_materials);
    loader.material = open.outer_material;
    loader.surfaces = std::move(open.outer_surfaces);
    loader.smooth_vertices = {};
    return objects;
}

void close_definition(Loader& loader) {
    const std::uint32_t last_material = *loader.material;
    const Geometry objects = close(loader);
    const OpenDefinition open = *std::exchange(loader.open, std::nullopt);
    bool inherits = false;  // whether it has objects with a reference's surface
    for (const Primitive p : objects.primitives) inherits |= p.material == open.outer_materials;
    const std::size_t length = loader.in.start() - open.first;
    const Definition definition{loader.text.substr(open.first, length), inherits,
                                last_material != open.outer_materials};
    if (!loader.definitions.emplace(open.name, definition).second) {
        loader.in.warn_at(open.keyword, "instance", "a second instance {}; the first one stays",
                          in_quotes(open.name));
    }
}

/// Reads the statements again, without diagnostics. Returns their contents.
Geometry replay(Loader& loader, const Definition& definition) {
    Geometry scene_geometry = std::exchange(loader.scene.geometry, {});
    DiagnosticLog silent({}, definition.statements, false);
    Loader again{{Reader(definition.statements, silent, object_names()), loader.options,
                  loader.directory, loader.default_material, std::move(loader.scene)},
                 definition.statements};
    again.material = loader.material;
    again.surfaces = std::move(loader.surfaces);
    read_objects(again);
    loader.scene = std::move(again.scene);
    loader.surfaces = std::move(again.surfaces);
    loader.material = again.material;
    return std::exchange(loader.scene.geometry, std::move(scene_geometry));
}

/// Makes an object from a definition, with the current material if it has none of its own.
DefinedObject make_object(Loader& loader, const Definition& definition) {
    const std::optional<std::uint32_t> before = loader.material;
    DefinedObject made;
    Geometry object = replay(loader, definition);
    made.material = std::exchange(loader.material, before);
    if (!object.primitives.empty()) {
        std::vector<Geometry>& objects = loader.scene.geometry.objects;
        made.object = static_cast<std::uint32_t>(objects.size());
        objects.push_back(std::move(object));
    }
    return made;
}

/// Adds the cost of reading a definition again. Returns whether the limit is exceeded.
bool is_too_much(Loader& loader, const Definition& definition) {
    loader.replayed += definition.statements.size();
    if (loader.replayed <= most_replayed) return false;
    loader.in.error("instance", "the instances amount to more than {} bytes", most_replayed);
    return true;
}

/// Returns the contents of a definition for the current material; nothing beyond the limit.
const DefinedObject* defined_object(Loader& loader, Definition& definition) {
    const std::uint32_t inherited =
        definition.inherits_surface ? loader.current_material() : no_index;
    const auto [known, is_new] = definition.objects.try_emplace(inherited);
    if (is_new) {
        if (is_too_much(loader, definition)) return nullptr;
        known->second = make_object(loader, definition);
    }
    return &known->second;
}

/// Adds an instance of a definition's contents. Returns false if that is impossible.
bool add_instance(Loader& loader, const Definition& definition, std::uint32_t object,
                  const Vec3& offset) {
    constexpr double harmless = 0x1p969;  // half a unit in the last place of the largest double
    Geometry& geometry = loader.scene.geometry;
    if (!(max_abs(offset) < harmless)) {
        if (is_too_much(loader, definition)) return false;
        if (!moved(geometry.objects[object], offset)) {
            loader.skip_degenerate("its position is not finite");
            return false;
        }
    }
    Affine place;
    place.origin = offset;
    geometry.instances.emplace_back(place, object);
    return true;
}

/// Instantiates a definition's contents at `offset`, and applies its last surface to what follows.
void refer_to(Loader& loader, Definition& definition, const Vec3& offset) {
    const DefinedObject* const made = defined_object(loader, definition);
    if (made == nullptr) return;
    if (made->object && !add_instance(loader, definition, *made->object, offset)) return;
    if (definition.sets_surface) loader.material = made->material;
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
                   loader.material,
                   std::exchange(loader.surfaces, {})};
    loader.smooth_vertices = {};
    loader.set_material(loader.default_material);  // replaces that of a reference
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
    refer_to(loader, found->second, offset);
}

}  // namespace etalon::prt
