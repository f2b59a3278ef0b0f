#pragma once

#include <png.h>

#include <cstdio>

#include "core/image/library_jump.h"

namespace etalon {

/// libpng's error function for a structure whose error pointer is a LibraryJump.
[[noreturn]] inline void leave_png(png_structp png, png_const_charp reason) {
    auto& jump = *static_cast<LibraryJump*>(png_get_error_ptr(png));
    std::snprintf(jump.reason, LibraryJump::capacity, "%s", reason);
    jump.leave();
}

/// libpng's warning function: warnings are not shown to the user.
inline void ignore_png_warning(png_structp, png_const_charp) {}

}  // namespace etalon
