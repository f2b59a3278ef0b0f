// Values of the options that accept only certain ones.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace etalon {

/// The values of each option that accepts only certain ones, for the completion of command lines.
using ValueChoices = std::map<const CLI::Option*, std::vector<std::string>>;

}  // namespace etalon
