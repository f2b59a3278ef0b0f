// Scenes as text. Numbers are the shortest that read back to the same value. The sign of zero,
// which has no effect on a scene, is dropped.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "core/numerics/vec.h"

// Adding zero turns -0 into 0. Text is made by fmt::format, which fmt's library has compiled;
// fmt::format_to would compile all of fmt anew in each file that writes.
template <>
struct fmt::formatter<etalon::Vec3> : fmt::formatter<std::string_view> {
    auto format(const etalon::Vec3& v, fmt::format_context& context) const {
        return fmt::formatter<std::string_view>::format(
            fmt::format("{} {} {}", v.x + 0.0, v.y + 0.0, v.z + 0.0), context);
    }
};

template <>
struct fmt::formatter<etalon::Color> : fmt::formatter<std::string_view> {
    auto format(const etalon::Color& c, fmt::format_context& context) const {
        return fmt::formatter<std::string_view>::format(
            fmt::format("{} {} {}", c.x + 0.0F, c.y + 0.0F, c.z + 0.0F), context);
    }
};

namespace etalon {

/// Lines of text, passed on in pieces, so that a scene may be larger than memory.
class LineWriter {
  public:
    using Sink = std::function<void(std::string_view)>;

    explicit LineWriter(Sink sink) : sink_(std::move(sink)) {}

    template <class... T>
    void line(fmt::format_string<T...> text, T&&... values) {
        buffer_ += fmt::format(text, std::forward<T>(values)...);
        buffer_ += '\n';
        if (buffer_.size() >= piece) flush();
    }

    /// Passes on the rest. This and line() pass on exceptions of the sink.
    void flush() {
        sink_(buffer_);
        buffer_.clear();
    }

  private:
    static constexpr std::size_t piece = std::size_t{1} << 16;

    Sink sink_;
    std::string buffer_;
};

}  // namespace etalon
