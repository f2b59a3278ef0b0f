#pragma once

#include <string>
#include <string_view>

#include "core/render/state.h"
#include "tests/catch.h"

namespace etalon::test {

/// Returns a reader that takes what it reads from the front of `bytes`, which must outlive it.
inline StateReader reader_of(std::string_view& bytes) {
    return StateReader([&bytes](char* to, std::size_t size) {
        if (size > bytes.size()) return false;
        bytes.remove_prefix(bytes.copy(to, size));
        return true;
    });
}

/// Writes a tile of a film and reads it into another one of the same window.
template <class AnyFilm>
void send_tile(AnyFilm& from, AnyFilm& to, const Imath::Box2i& tile) {
    std::string bytes;
    StateWriter writer([&](std::string_view piece) { bytes += piece; });
    from.transfer(writer, tile);
    std::string_view left = bytes;
    StateReader reader = reader_of(left);
    to.transfer(reader, tile);
    CHECK((!reader.failed() && left.empty()));
}

}  // namespace etalon::test
