#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/formats/pbrt/binder.h"
#include "core/formats/pbrt/frame.h"
#include "core/formats/pbrt/graphics_state.h"
#include "core/formats/pbrt/log.h"
#include "core/formats/pbrt/material_pool.h"
#include "core/formats/pbrt/statement_reader.h"
#include "core/formats/pbrt/token_stream.h"

namespace etalon::pbrt {

enum class Block : std::uint8_t { options, world };

struct SavedTransform {
    TransformScope scope;
    bool is_attribute;  ///< whether AttributeBegin or ObjectBegin saved it
    FileLoc where;
};

struct SavedAttributes {
    GraphicsState state;
    std::size_t numbers, spectra, materials;  ///< blocks of the names
    FileLoc where;
};

/// State of reading a frame.
struct FrameState {
    Frame frame{};
    Block block = Block::options;
    TransformScope transform{};
    GraphicsState graphics{};
    std::vector<SavedTransform> saved_transforms{};
    std::vector<SavedAttributes> saved_attributes{};
    TextureNames textures{};
    ScopedNames<std::shared_ptr<const StatedMaterial>> materials{};
    std::unordered_map<std::string, std::uint32_t> media{}, objects{};
    std::unordered_map<std::string, std::shared_ptr<TransformState>> coordinate_systems{};
    std::uint32_t object = none;  ///< number of the object being defined
    MaterialPool material_pool{};
};

/// Severity of an unknown plugin in pbrt-v3, and what happens instead.
struct Unknown {
    enum class Grade : std::uint8_t { warning, error, fatal };

    Grade grade;
    std::string_view consequence;
};

/// State of reading a PBRT file.
struct Parser {
    Parser(std::string_view text, const std::string& path, const std::string& root, Log& l)
        : log(l), tokens(text, path, root, l), in(tokens, l) {}

    Log& log;
    TokenStream tokens;
    StatementReader in;
    FrameState now{};
    std::vector<Frame> frames{};

    Frame& frame() { return now.frame; }
    Binder binder() { return {now.textures, tokens, log}; }

    /// Returns the numbers of the current transformation in the frame.
    TransformPair transform_pair();

    /// The same at the start time, for items that cannot move; warns if the transformation moves.
    std::uint32_t start_transform();

    /// Returns the numbers of the current media; reports unknown names.
    MediumInterface current_media(FileLoc where);

    /// Takes the type of a named plugin from its parameters; reports a missing one.
    std::string take_type(ParameterList& list);

    /// Makes a plugin from the parameters and reports those that it does not use. Returns nothing
    /// if a required one is missing.
    std::optional<Plugin> make_plugin(const PluginType& type, ParameterList& list);

    /// Returns whether the plugin's parameters are compatible, so that it is not left out; reports
    /// it if they are not.
    bool check(const Plugin& plugin);

    /// Adds a material, made from the values of the lists, of which the first has precedence.
    std::uint32_t add_material(const PluginType& type, std::span<ParameterList* const> lists,
                               FileLoc where);

    /// Finds a plugin type by its name. If there is none of that name, reports which there are and
    /// what happens instead.
    const PluginType* find_type(Category category, const std::string& name, Unknown unknown);
};

/// A directive that a file can have.
struct Directive {
    enum class Allowed : std::uint8_t { anywhere, in_options, in_world };

    std::string_view word;
    Allowed allowed;
    void (*run)(Parser&);
};

/// Returns null for a word that is not a directive.
const Directive* find_directive(std::string_view word);

// The directives, by subject.
std::span<const Directive> transform_directives();
std::span<const Directive> option_directives();
std::span<const Directive> block_directives();
std::span<const Directive> look_directives();
std::span<const Directive> shape_directives();
std::span<const Directive> medium_directives();

/// Ends the frame: reports blocks that are still open and binds lazily bound names.
void end_frame(Parser& p);

}  // namespace etalon::pbrt
