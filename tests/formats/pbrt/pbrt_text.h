// Parsing PBRT text in a test.
#pragma once

#include <string>
#include <vector>

#include "core/formats/pbrt/parse.h"
#include "tests/catch.h"

namespace etalon::pbrt {

using Messages = std::vector<std::string>;

inline Messages messages(const ParsedFile& file) {
    Messages list;
    for (const Diagnostic& d : file.diagnostics) list.push_back(to_string(d));
    return list;
}

/// Reads `text` as the file "a.pbrt".
inline ParsedFile parse_text(const std::string& text, const ParseOptions& options = {}) {
    return parse(text, "a.pbrt", options);
}

/// Reads `text` as the world of the file "a.pbrt". The first line of the world is line 1.
inline ParsedFile parse_world(const std::string& text) {
    return parse_text("WorldBegin " + text + "\nWorldEnd");
}

/// Returns the one frame of a text without diagnostics.
inline Frame good_frame(const std::string& text) {
    ParsedFile file = parse_text(text);
    CAPTURE(text);
    CHECK(messages(file) == Messages{});
    CHECK_FALSE(file.is_fatal);
    REQUIRE(file.frames.size() == 1);
    return std::move(file.frames.front());
}

/// The same for the text of a world.
inline Frame good_world(const std::string& text) {
    return good_frame("WorldBegin\n" + text + "\nWorldEnd");
}

/// Returns the frame of a world with one diagnostic, whose message is checked.
inline Frame world_with(const std::string& text, const std::string& message) {
    ParsedFile file = parse_world(text);
    CAPTURE(text);
    CHECK(messages(file) == Messages{message});
    REQUIRE(file.frames.size() == 1);
    return std::move(file.frames.front());
}

inline Matrix4 start(const Frame& frame, const Shape& shape) {
    return frame.transforms[shape.to_world.start];
}

inline Matrix4 end(const Frame& frame, const Shape& shape) {
    return frame.transforms[shape.to_world.end];
}

/// Returns the image of a point, in affine coordinates.
inline Vec3 image(const Matrix4& m, const Vec3& p) {
    Vec3 q;
    for (int r = 0; r < 3; ++r) {
        const auto& row = m[static_cast<std::size_t>(r)];
        q[r] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
    }
    return q;
}

}  // namespace etalon::pbrt
