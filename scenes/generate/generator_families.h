// The families of scenes, and the table that names them. After Haines 1987, "A Proposal for
// Standard Graphics Environments" (the Standard Procedural Databases), whose subjects they share;
// the constructions are this project's own. Y is up and the ground is y = 0 in all of them.
//
// To add a family: its function here, its file, its line in the table of generator_families.cpp,
// and its count of primitives in tests/scenes/family_counts_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/formats/write/p3f_writer.h"

namespace etalon::generate {

using Writer = P3fWriter;

/// Write a whole scene; the table says what `size` means. Scenes with instances are PBRT, which
/// alone has them.
void sphereflake(Writer& out, std::int64_t size);
void tetra(Writer& out, std::int64_t size);
void mountain(Writer& out, std::int64_t size);
void rings(Writer& out, std::int64_t size);
void gears(Writer& out, std::int64_t size);
void tree(Writer& out, std::int64_t size);
void soup(Writer& out, std::int64_t size);
void spheres(Writer& out, std::int64_t size);
void forest(LineWriter& out, std::int64_t size);
void plaza(LineWriter& out, std::int64_t size);

struct Family {
    std::string_view name;
    /// Passes the text to `sink`, after a one-line comment. Passes on exceptions of the sink.
    void (*generate)(const LineWriter::Sink& sink, const std::string& comment, std::int64_t size);
    std::string_view extension;    ///< of files of its format
    std::string_view description;  ///< with the number of primitives as a function of N, the size
    std::int64_t default_size, min_size, max_size;
};

std::span<const Family> families();

/// Returns the family called `name`, or nullptr.
const Family* find_family(std::string_view name);

/// Writes the ground of the classic families: a large square in a material of its own.
void ground(Writer& out,
            const P3fMaterial& material = {.diffuse = {1.0F, 0.85F, 0.62F}, .kd = 0.8});

}  // namespace etalon::generate
