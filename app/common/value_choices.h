// The values that options take, where they take only some.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace etalon {

/// The values of each option that takes only certain ones, for the completion of command lines.
using ValueChoices = std::map<const CLI::Option*, std::vector<std::string>>;

}  // namespace etalon
