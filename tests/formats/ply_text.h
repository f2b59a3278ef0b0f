// Small PLY files made for tests, in every encoding.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

namespace etalon {

/// Writes the numbers of a PLY file as text ("ascii") or binary.
class PlyText {
  public:
    PlyText(std::string encoding, const std::string& header) : encoding_(std::move(encoding)) {
        text_ = "ply\nformat " + encoding_ + " 1.0\n" + header + "end_header\n";
    }

    template <class T>
    PlyText& operator<<(T value) {
        if (encoding_ == "ascii") {
            text_ += std::to_string(value) + (++words_ % 7 == 0 ? "\r\n" : " ");
            return *this;
        }
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof value);
        const bool little = encoding_ == "binary_little_endian";
        if (little != (std::endian::native == std::endian::little)) {
            std::reverse(bytes, bytes + sizeof bytes);
        }
        text_.append(bytes, sizeof bytes);
        return *this;
    }

    const std::string& text() const { return text_; }

  private:
    std::string encoding_, text_;
    int words_ = 0;
};

inline const std::vector<std::string> ply_encodings{"ascii", "binary_little_endian",
                                                    "binary_big_endian"};

}  // namespace etalon
