// The state of a rendering as bytes: what another process needs to go on from there. Objects that
// have some say what it is once, for both ways, in a `template <class Bytes> void
// transfer(Bytes&)`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace etalon {

/// True if all that a value is lies in its own bytes; vectors have constructors, but no more.
template <class T>
inline constexpr bool is_plain = std::is_standard_layout_v<T>&& std::is_trivially_destructible_v<T>;

/// Writes values as they are in memory, vectors after their lengths.
class StateWriter {
  public:
    using Sink = std::function<void(std::string_view)>;

    /// The sink is called with one piece of the bytes after the other.
    explicit StateWriter(Sink sink) : sink_(std::move(sink)) {}

    template <class T>
    void operator()(const T& value) {
        static_assert(is_plain<T>);
        sink_({reinterpret_cast<const char*>(&value), sizeof value});
    }

    template <class T, class Allocator>
    void operator()(const std::vector<T, Allocator>& values) {
        static_assert(is_plain<T>);
        (*this)(static_cast<std::uint64_t>(values.size()));
        sink_({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }

    /// Says what must hold of the values so far, for whoever reads them.
    void expect(bool) {}

  private:
    Sink sink_;
};

/// Reads them again, in the same order, into objects made by the same settings.
class StateReader {
  public:
    /// Fills a piece of memory with the next bytes; returns whether there are so many.
    using Source = std::function<bool(char*, std::size_t)>;

    explicit StateReader(Source source) : source_(std::move(source)) {}

    template <class T>
    void operator()(T& value) {
        static_assert(is_plain<T>);
        read(&value, sizeof value);
    }

    /// A vector that has elements keeps their number: bytes that say another one do not fit.
    template <class T, class Allocator>
    void operator()(std::vector<T, Allocator>& values) {
        static_assert(is_plain<T>);
        std::uint64_t size = 0;
        read(&size, sizeof size);
        if (size != values.size() && (!values.empty() || size > largest)) failed_ = true;
        constexpr std::uint64_t step = 1 << 16;  // memory grows with what there really is
        for (std::uint64_t done = 0; done < size && !failed_; done += step) {
            const std::uint64_t count = std::min(size - done, step);
            if (values.size() < done + count) values.resize(done + count);
            read(values.data() + done, count * sizeof(T));
        }
    }

    /// Of a byte that is neither 0 nor 1 no truth value can be made.
    void operator()(bool& value) {
        std::uint8_t byte = 0;
        (*this)(byte);
        expect(byte <= 1);
        value = byte == 1;
    }

    /// Fails unless the values so far are those of such objects.
    void expect(bool holds) { failed_ = failed_ || !holds; }

    /// Returns whether the bytes were not those of such objects.
    bool failed() const { return failed_; }

  private:
    /// Pixels of the largest image.
    static constexpr std::uint64_t largest = std::uint64_t{1} << 32;

    void read(void* to, std::size_t size) {
        failed_ = failed_ || !source_(static_cast<char*>(to), size);
    }

    Source source_;
    bool failed_ = false;
};

}  // namespace etalon
