// The numbers of a PLY file in order, as text or binary.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/formats/ply/ply_header.h"
#include "core/numerics/vec.h"

namespace etalon::ply {

/// Whether binary numbers have the byte order of this machine.
enum class ByteOrder { native, reversed };

/// Reads a binary number, which need not be aligned.
template <class T, ByteOrder order>
T load(const char* p) {
    using Bits = std::conditional_t<
        sizeof(T) == 8, std::uint64_t,
        std::conditional_t<sizeof(T) == 4, std::uint32_t,
                           std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;
    Bits bits;
    std::memcpy(&bits, p, sizeof bits);
    if constexpr (order == ByteOrder::reversed) {
        if constexpr (sizeof(T) == 8) bits = __builtin_bswap64(bits);
        if constexpr (sizeof(T) == 4) bits = __builtin_bswap32(bits);
        if constexpr (sizeof(T) == 2) bits = __builtin_bswap16(bits);
    }
    return std::bit_cast<T>(bits);
}

/// Calls f(T()) with the C++ type of `type`.
template <class F>
auto with_type(Type type, F&& f) {
    switch (type) {
        case Type::int8:
            return f(std::int8_t());
        case Type::uint8:
            return f(std::uint8_t());
        case Type::int16:
            return f(std::int16_t());
        case Type::uint16:
            return f(std::uint16_t());
        case Type::int32:
            return f(std::int32_t());
        case Type::uint32:
            return f(std::uint32_t());
        case Type::float32:
            return f(float());
        default:
            return f(double());
    }
}

/// The reason why a number that was read makes the rest unreadable, or empty.
class Unreadable {
  public:
    void fail(std::string reason) { reason_ = std::move(reason); }

  protected:
    const std::string& reason_or(const std::string& other) const {
        return reason_.empty() ? other : reason_;
    }

  private:
    std::string reason_;
};

/// Both sources of numbers have these members.
template <ByteOrder order>
class BinaryNumbers : public Unreadable {
  public:
    static constexpr bool is_binary = true;

    BinaryNumbers(std::string_view file, std::size_t first)
        : file_(file.data()), next_(file_ + first), last_(file_ + file.size()) {}

    /// Reads a number; returns false if there is none.
    bool read(Type type, double& value) {
        if (remaining() < size_of(type)) return false;
        value = with_type(
            type, [&](auto t) { return static_cast<double>(load<decltype(t), order>(next_)); });
        next_ += size_of(type);
        return true;
    }

    /// Skips `count` numbers; returns false if there are fewer.
    bool skip(Type type, std::uint64_t count) {
        if (count > remaining() / size_of(type)) return false;
        next_ += count * size_of(type);
        return true;
    }

    /// Returns how many elements, at most, the rest can hold.
    std::uint64_t room_for(const Element& element) const {
        return element.properties.empty() ? element.count : remaining() / element.least_bytes();
    }

    /// Writes the triangles of a face whose corners are numbers of four bytes. Reads four of them
    /// and writes at least four numbers. Returns the end of what is written.
    static std::uint32_t* copy_corners(const char* corners, unsigned count, std::uint32_t* out) {
        for (int i = 0; i < 4; ++i) out[i] = load<std::uint32_t, order>(corners + 4 * i);
        if (count == 3) return out + 3;
        const std::uint32_t first = out[0], third = out[2];
        out[4] = first;
        out[5] = third;
        return out + 6;
    }

    const char*& position() { return next_; }
    const char* last() const { return last_; }
    std::size_t remaining() const { return static_cast<std::size_t>(last_ - next_); }

    /// Return the offset of the next number, and the error: that of fail(), or that of read() or
    /// skip().
    std::size_t offset() const { return DiagnosticLog::whole_file; }
    std::string error() const { return reason_or("the file ends"); }

  private:
    const char *file_, *next_, *last_;
};

class AsciiNumbers : public Unreadable {
  public:
    static constexpr bool is_binary = false;

    AsciiNumbers(std::string_view file, std::size_t first)
        : file_(file.data()), next_(file_ + first), last_(file_ + file.size()) {
        skip_blanks();
    }

    /// Infinities and values beyond the range of double become infinite, and "nan" becomes NaN.
    bool read(Type, double& value);

    bool skip(Type type, std::uint64_t count) {
        double ignored;
        for (; count > 0; --count) {
            if (!read(type, ignored)) return false;
        }
        return true;
    }

    std::uint64_t room_for(const Element& element) const {
        if (element.properties.empty()) return element.count;
        return (remaining() + 1) / (2 * element.properties.size());  // a digit and a blank each
    }

    std::size_t remaining() const { return static_cast<std::size_t>(last_ - next_); }
    std::size_t offset() const { return static_cast<std::size_t>(next_ - file_); }
    std::string error() const;

  private:
    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    void skip_blanks() {
        while (next_ != last_ && is_blank(*next_)) ++next_;
    }
    std::string_view word() const {
        const char* const end = std::find_if(next_, last_, is_blank);
        return {next_, static_cast<std::size_t>(end - next_)};
    }

    const char *file_, *next_, *last_;
};

}  // namespace etalon::ply
