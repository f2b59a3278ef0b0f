#pragma once

#include <string>
#include <vector>

#include "app/common/without_repeats.h"

namespace etalon {

/// Joins the words of a list that was split at all commas, also at those within a name: of each
/// word and those after it, as many as are together a name. Words of no name stay as they are; what
/// is there twice is taken once.
template <class IsName>
std::vector<std::string> joined_words(const std::vector<std::string>& words,
                                      const IsName& is_name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < words.size();) {
        std::string name = words[i], run = words[i];
        std::size_t next = i + 1;
        for (std::size_t k = i + 1; k < words.size(); ++k) {
            run += ',' + words[k];
            if (!is_name(run)) continue;
            name = run;
            next = k + 1;
        }
        names.push_back(std::move(name));
        i = next;
    }
    return without_repeats(names);
}

}  // namespace etalon
