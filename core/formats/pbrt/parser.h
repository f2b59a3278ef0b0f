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
    Place where;
};

struct SavedAttributes {
    GraphicsState state;
    std::size_t numbers, spectra, materials;  ///< blocks of the names
    Place where;
};

/// What is known while a frame is read.
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

/// How bad it is that a plugin is unknown, as pbrt-v3 takes it, and what happens instead.
struct Unknown {
    enum class Grade : std::uint8_t { warning, error, fatal };

    Grade grade;
    std::string_view consequence;
};

/// A PBRT file being read.
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

    /// Returns the numbers, in the frame, of the current transformation.
    TransformPair transform_pair();

    /// The same at the start time, for what cannot move; says so if it does.
    std::uint32_t start_transform();

    /// Returns the numbers of the current media; says which names are unknown.
    MediumInterface current_media(Place where);

    /// Takes the type of a named plugin from its parameters; says so if it is missing.
    std::string take_type(ParameterList& list);

    /// Makes a plugin of the parameters and says which of them it does not use. Returns nothing if
    /// a required one is missing.
    std::optional<Plugin> make_plugin(const PluginType& type, ParameterList& list);

    /// Returns whether its parameters go together, so that it is not left out; says it if they do
    /// not.
    bool check(const Plugin& plugin);

    /// Adds a material, made of the lists' values, of which the first list has precedence.
    std::uint32_t add_material(const PluginType& type, std::span<ParameterList* const> lists,
                               Place where);

    /// Finds a plugin type by its name; says which there are, and what comes of it, if there is
    /// none of that name.
    const PluginType* find_type(Category category, const std::string& name, Unknown unknown);
};

/// A statement that a file can have.
struct Directive {
    enum class Allowed : std::uint8_t { anywhere, in_options, in_world };

    std::string_view word;
    Allowed allowed;
    void (*run)(Parser&);
};

/// Returns null for a word that is no directive.
const Directive* find_directive(std::string_view word);

// The directives, by what they are about.
std::span<const Directive> transform_directives();
std::span<const Directive> option_directives();
std::span<const Directive> block_directives();
std::span<const Directive> look_directives();
std::span<const Directive> shape_directives();
std::span<const Directive> medium_directives();

/// Ends the frame: what is left open is said, and what is bound late is bound.
void end_frame(Parser& p);

}  // namespace etalon::pbrt
