#include "scenes/generate/scene_text.h"

#include "scenes/generate/generator_families.h"

namespace etalon::generate {

std::string scene_text(const std::string& family, std::int64_t size) {
    std::string text;
    find_family(family)->generate([&](std::string_view part) { text += part; }, family, size);
    return text;
}

}  // namespace etalon::generate
