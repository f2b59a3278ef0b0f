#include "core/formats/write/loss.h"

#include <algorithm>

namespace etalon {

void Losses::add(std::string_view what) {
    const auto known = std::ranges::find(list_, what, &Loss::what);
    if (known == list_.end()) {
        list_.push_back({std::string(what), 1});
    } else {
        ++known->count;
    }
}

}  // namespace etalon
