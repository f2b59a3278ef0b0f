#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/pbrt/declared_type.h"
#include "core/formats/pbrt/number.h"
#include "core/formats/pbrt/parameter_list.h"
#include "core/formats/pbrt/spectrum_files.h"
#include "core/formats/pbrt/token_stream.h"

namespace etalon::pbrt {

/// Reads the parameters of one statement: "type name" and a value, or values in brackets.
class ParameterReader {
  public:
    ParameterReader(TokenStream& tokens, SpectrumFiles& spectra, Log& log,
                    std::string_view directive)
        : tokens_(tokens), spectra_(spectra), log_(log), directive_(directive) {}

    /// Reads the next parameter and adds it if it can be used. Returns false if pbrt-v3 would stop
    /// at it.
    bool read(ParameterList& list);

  private:
    bool read_values();
    void take_numbers();
    bool read_value();
    bool read_string();
    bool read_number_word();
    void add_number(const LooseNumber& number, FileLoc loc);
    bool fail(std::string_view expected);

    /// Converts the values to the parameter's type. Returns false, and reports it, if that is
    /// impossible.
    bool convert();
    bool convert_strings();
    bool convert_numbers();
    void convert_flags();
    void convert_spectrum_files();

    template <class... T>
    bool refuse(fmt::format_string<T...> text, T&&... values) {
        log_.error(given_.where, "type", text, std::forward<T>(values)...);
        return false;
    }

    TokenStream& tokens_;
    SpectrumFiles& spectra_;
    Log& log_;
    std::string_view directive_;

    // The parameter being read.
    const DeclaredType* declared_ = nullptr;
    GivenParameter given_{};
    std::vector<float> numbers_;
    std::vector<std::int32_t> integers_;  ///< instead of numbers_ if integers are declared
    std::vector<std::string> strings_;
};

/// Warns that the characters after a number are ignored.
void warn_of_extra(const LooseNumber& number, std::string_view word, FileLoc loc, Log& log);

}  // namespace etalon::pbrt
