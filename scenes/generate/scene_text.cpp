#include "scenes/generate/scene_text.h"

#include "scenes/generate/generator_families.h"

namespace etalon::generate {

std::string scene_text(const std::string& family, std::int64_t size) {
    std::string text;
    Writer writer([&](std::string_view part) { text += part; });
    find_family(family)->generate(writer, size);
    writer.flush();
    return text;
}

}  // namespace etalon::generate
