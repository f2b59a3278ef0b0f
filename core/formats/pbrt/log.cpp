#include "core/formats/pbrt/log.h"

namespace etalon::pbrt {

std::uint32_t Log::add_file(const std::string& name) {
    files_.push_back(name);
    return static_cast<std::uint32_t>(files_.size() - 1);
}

}  // namespace etalon::pbrt
