#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/formats/pbrt/log.h"
#include "core/formats/pbrt/parameter_list.h"
#include "core/formats/pbrt/parameters.h"
#include "core/formats/pbrt/scoped_names.h"
#include "core/formats/pbrt/token_stream.h"

namespace etalon::pbrt {

/// Numbers of the textures defined so far, by name.
struct TextureNames {
    ScopedNames<std::uint32_t> numbers, spectra;
};

/// Binds the parameters of a file to those of a plugin.
class Binder {
  public:
    Binder(const TextureNames& textures, const TokenStream& tokens, Log& log)
        : textures_(textures), tokens_(tokens), log_(log) {}

    /// Takes the values from the lists, of which the first has precedence. Reports values that
    /// cannot be used and keeps their defaults. Returns nothing if a required parameter is missing.
    std::optional<std::vector<Argument>> bind(const PluginType& type,
                                              std::span<ParameterList* const> lists, FileLoc where);

  private:
    std::optional<Values> find(const ParameterSpec& spec, std::span<ParameterList* const> lists);
    std::optional<Values> find(const ParameterSpec& spec, const Spelling& spelling,
                               ParameterList& list);
    std::optional<Values> texture(const ParameterSpec& spec, GivenParameter& given);
    bool is_usable(const ParameterSpec& spec, const GivenParameter& given);
    bool has_right_count(const ParameterSpec& spec, const GivenParameter& given);
    bool is_accepted(const ParameterSpec& spec, Values& values, FileLoc where);
    Values convert(const ParameterSpec& spec, GivenParameter& given);

    const TextureNames& textures_;
    const TokenStream& tokens_;
    Log& log_;
};

}  // namespace etalon::pbrt
