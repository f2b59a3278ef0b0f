// instance, end_instance and instance_of. An instance is a piece of text: it is read once where it
// is defined, so that its errors are told, and again for every reference, where its objects are
// moved and its surfaces take effect, for what comes after the reference as well.
#include <algorithm>

#include "core/formats/prt/loader.h"
#include "core/scene/transformed.h"

namespace etalon::prt {
namespace {

/// More text than that is not replayed: a small file could ask for any amount.
constexpr std::size_t most_replayed = std::size_t{1} << 27;

template <class T>
void cut(std::vector<T>& v, std::size_t size) {
    v.erase(v.begin() + static_cast<std::ptrdiff_t>(size), v.end());
}

void cut(Scene& scene, const SceneMark& mark) {
    cut(scene.primitives, mark.primitives);
    cut(scene.materials, mark.materials);
    cut(scene.vertices, mark.vertices);
    const auto cut_kinds = [&]<std::size_t... kind>(std::index_sequence<kind...>) {
        (cut(std::get<kind>(scene.shapes), mark.shapes[kind]), ...);
    };
    cut_kinds(std::make_index_sequence<shape_kinds>());
}

/// The end of the definition: its objects are no part of the scene yet.
OpenDefinition close(Loader& loader) {
    const OpenDefinition open = *loader.open;
    cut(loader.scene, open.mark);
    loader.material = open.outer_material;
    loader.open.reset();
    return open;
}

/// Whether the definition has objects of the surface that stands in for that of a reference.
bool inherits_surface(const Scene& scene, const SceneMark& mark) {
    const auto first = scene.primitives.begin() + static_cast<std::ptrdiff_t>(mark.primitives);
    return std::any_of(first, scene.primitives.end(),
                       [&](const Primitive& p) { return p.material == mark.materials; });
}

void close_definition(Loader& loader) {
    const bool inherits = inherits_surface(loader.scene, loader.open->mark);
    const OpenDefinition open = close(loader);
    const std::size_t length = loader.in.start() - open.first;
    const Definition definition{loader.text.substr(open.first, length), inherits};
    if (!loader.definitions.emplace(open.name, definition).second) {
        loader.in.warn_at(open.keyword, "instance", "a second instance {}; the first one stays",
                          in_quotes(open.name));
    }
}

/// Reads the statements once more, silently.
void replay(Loader& loader, const Definition& definition, const Vec3& offset) {
    const SceneMark mark(loader.scene);
    const std::optional<std::uint32_t> before = loader.material;
    DiagnosticLog silent({}, definition.statements, false);
    Loader again{{Reader(definition.statements, silent, object_names()), loader.options,
                  loader.directory, loader.default_material, std::move(loader.scene)},
                 definition.statements};
    again.material = loader.material;
    read_objects(again);
    loader.scene = std::move(again.scene);
    loader.material = again.material;
    if (!move_since(loader.scene, mark.primitives, mark.vertices, offset)) {
        cut(loader.scene, mark);
        loader.material = before;
        loader.leave_out("it lies beyond all numbers");
    }
}

}  // namespace

SceneMark::SceneMark(const Scene& scene)
    : primitives(scene.primitives.size()),
      materials(scene.materials.size()),
      vertices(scene.vertices.size()),
      shapes(std::apply([](const auto&... v) { return std::array{v.size()...}; }, scene.shapes)) {}

void read_instance(Loader& loader) {
    Reader& in = loader.in;
    const std::string_view name = in.word("name");
    if (!in.ok()) return;
    if (loader.open) {
        ++loader.open->nested;
        return in.error("instance", "an instance inside instance {}", in_quotes(loader.open->name));
    }
    loader.open = {name,           in.start(), in.tokens().offset(), 0, SceneMark(loader.scene),
                   loader.material};
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
    const OpenDefinition open = close(loader);
    loader.in.warn_at(open.keyword, "instance", "instance {} has no end; it is left out",
                      in_quotes(open.name));
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
