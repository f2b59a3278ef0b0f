// Scenes written as PBRT v3, checked by the rules of its parser.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/formats/load.h"
#include "core/formats/write/write.h"

namespace etalon {

using Strings = std::vector<std::string>;

/// A directive with the numbers and names that follow it.
struct Directive {
    std::string name, type;
    std::vector<double> numbers;                             ///< those before any parameter
    bool bracketed = false;                                  ///< whether they were in brackets
    std::map<std::string, std::vector<std::string>> values;  ///< "float fov" -> 45
};

/// Parses as strictly as PBRT: fixed counts, brackets for matrices only, names defined before use,
/// closed blocks, options before the world.
std::vector<Directive> parsed_strictly(const std::string& text);

/// Returns the directives of the scene as it is written.
std::vector<Directive> converted(const LoadResult& r);

/// Returns the first directive of that name.
const Directive& find(const std::vector<Directive>& list, const std::string& name);

/// Returns the first value of a parameter.
double number(const Directive& d, const std::string& name);

/// Returns what a format could not express.
Strings names_of(const std::vector<ConversionWarning>& lost);

}  // namespace etalon
