// The state of a rendering as bytes, from which another process can continue it. Objects with a
// state define it once, for reading and writing, in a `template <class Bytes> void
// transfer(Bytes&)`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace etalon {

/// True if all of a value is in its own bytes. Vectors qualify, though they have constructors.
template <class T>
inline constexpr bool is_plain = std::is_standard_layout_v<T>&& std::is_trivially_destructible_v<T>;

/// Writes values as they are in memory, and vectors after their lengths.
class StateWriter {
  public:
    using Sink = std::function<void(std::string_view)>;

    /// The sink is called with consecutive pieces of the bytes.
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

    /// States a condition that a reader checks. A writer need not.
    void expect(bool) {}

  private:
    Sink sink_;
};

/// Reads the values in the same order, into objects made with the same settings.
class StateReader {
  public:
    /// Fills a piece of memory with the next bytes; returns false if there are not enough.
    using Source = std::function<bool(char*, std::size_t)>;

    explicit StateReader(Source source) : source_(std::move(source)) {}

    template <class T>
    void operator()(T& value) {
        static_assert(is_plain<T>);
        read(&value, sizeof value);
    }

    /// Reads a vector. If it has elements, bytes with another number of elements do not fit.
    template <class T, class Allocator>
    void operator()(std::vector<T, Allocator>& values) {
        static_assert(is_plain<T>);
        std::uint64_t size = 0;
        read(&size, sizeof size);
        if (size != values.size() && (!values.empty() || size > largest)) failed_ = true;
        constexpr std::uint64_t step = 1 << 16;  // memory grows only with the bytes that exist
        for (std::uint64_t done = 0; done < size && !failed_; done += step) {
            const std::uint64_t count = std::min(size - done, step);
            if (values.size() < done + count) values.resize(done + count);
            read(values.data() + done, count * sizeof(T));
        }
    }

    /// Reads a truth value; bytes other than 0 and 1 are errors.
    void operator()(bool& value) {
        std::uint8_t byte = 0;
        (*this)(byte);
        expect(byte <= 1);
        value = byte == 1;
    }

    /// Fails unless the condition holds for the values so far.
    void expect(bool holds) { failed_ = failed_ || !holds; }

    /// Returns whether the bytes did not fit the objects.
    bool failed() const { return failed_; }

  private:
    /// Largest number of elements of a vector: the pixels of the largest image.
    static constexpr std::uint64_t largest = std::uint64_t{1} << 32;

    void read(void* to, std::size_t size) {
        failed_ = failed_ || !source_(static_cast<char*>(to), size);
    }

    Source source_;
    bool failed_ = false;
};

}  // namespace etalon
