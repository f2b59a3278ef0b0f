#pragma once

#include <cstdint>
#include <string>

#include "core/scene/scene.h"

namespace etalon::test {

/// Returns the standard output of `etalon-scenes FAMILY --size N`.
std::string family_text(const std::string& family, std::int64_t size);

/// Returns that scene; fails the test case unless it loads without a diagnostic.
Scene family_scene(const std::string& family, std::int64_t size);

}  // namespace etalon::test
