#include "core/formats/write/conversion_warnings.h"

#include <algorithm>

namespace etalon {

void ConversionWarnings::add(std::string_view what) {
    const auto known = std::ranges::find(list_, what, &ConversionWarning::what);
    if (known == list_.end()) {
        list_.push_back({std::string(what), 1});
    } else {
        ++known->count;
    }
}

}  // namespace etalon
