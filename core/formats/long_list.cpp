// Lists of numbers of any length: the beginning is read on this thread, the rest of a long one on
// all.
#include <algorithm>
#include <array>
#include <cstring>

#include "core/formats/number_list.h"
#include "core/parallel/large_pages.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

constexpr std::size_t most_at_once = 1 << 14;  ///< numbers that fit the first-level cache
constexpr std::size_t piece_size = 1 << 16;    ///< bytes of text
constexpr std::size_t pieces_in_batch = 32;
constexpr std::size_t shortest_shared = 1 << 20;  ///< bytes for which waking threads pays

/// Text of a list. The part that was read predicts the size of the rest.
struct ListText {
    const char *first, *last;  ///< up to its bracket, if there is one
    std::size_t before;        ///< number of values that are not of this list

    /// Reserves space for `more` values and for those expected after p, judging by the text so far,
    /// but not for many more than there are: the first ones may be shorter than the rest.
    template <class T>
    void make_room(const char* p, std::size_t more, std::vector<T>& values) const {
        const std::size_t count = values.size();
        if (values.capacity() - count >= more) return;
        const double numbers_a_byte =
            static_cast<double>(count - before + more) / static_cast<double>(p - first);
        const auto to_come =
            static_cast<std::size_t>(1.02 * numbers_a_byte * static_cast<double>(last - p));
        constexpr std::size_t few = 100'000;
        const std::size_t most = count + more < few ? 7 * (count + more) : to_come;
        values.reserve(count + more + std::min(to_come, most));
        prefer_large_pages(values.data() + count, (values.capacity() - count) * sizeof(T));
    }
};

/// Text that one thread reads.
template <class T>
struct Piece {
    const char *first, *last;
    const char* end;           ///< end of what was read: `last`, or the first other character
    std::vector<T> numbers{};  ///< with space for all numbers that the text can hold
    std::size_t count = 0;

    void read() {
        numbers.resize(std::max(numbers.size(), static_cast<std::size_t>(last - first + 1) / 2));
        end = first;
        count = read_numbers(end, last, std::span<T>(numbers));
        const bool ends_line = last[-1] == '\n';
        if (ends_line || !std::memchr(first, '#', static_cast<std::size_t>(last - first))) return;
        end = first;  // a comment may continue behind it
        count = 0;
    }
};

/// Returns the end of a piece that begins at p: after a line, so that the next piece does not begin
/// in a comment; if there is none, at a blank. Null if there is neither.
const char* cut(const char* p, const char* last) {
    if (static_cast<std::size_t>(last - p) <= piece_size) return last;
    const char* const least = p + piece_size / 2;
    const char* const most = p + piece_size;
    const auto find_back = [&](auto may_end) {
        const char* q = most;
        while (q != least && !may_end(q[-1])) --q;
        return q != least ? q : nullptr;
    };
    if (const char* const q = find_back([](char c) { return c == '\n'; })) return q;
    return find_back([](char c) { return c == ' ' || c == '\t'; });
}

/// Consecutive pieces.
template <class T>
class Batch {
  public:
    bool empty() const { return size_ == 0; }

    /// Takes as many pieces as there is text for, and moves p behind them.
    void take(const char*& p, const char* last) {
        for (size_ = 0; size_ < pieces_in_batch && p != last; ++size_) {
            const char* const end = cut(p, last);
            if (!end) {
                p = last;  // not a list of numbers
                return;
            }
            pieces_[size_].first = p;
            pieces_[size_].last = p = end;
        }
    }

    void read() {
        parallel_for(size_, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) pieces_[i].read();
        });
    }

    /// Appends the numbers of the pieces up to the first that is not a list as a whole, and moves p
    /// there. Returns whether all were lists.
    bool append_to(const char*& p, const ListText& text, std::vector<T>& values) const {
        for (const Piece<T>& piece : std::span(pieces_).first(size_)) {
            text.make_room(piece.last, piece.count, values);
            values.insert(values.end(), piece.numbers.data(), piece.numbers.data() + piece.count);
            p = piece.end;
            if (p != piece.last) return false;
        }
        return true;
    }

  private:
    std::array<Piece<T>, pieces_in_batch> pieces_{};
    std::size_t size_ = 0;
};

/// Returns the number of values to reserve space for at p: as many as may precede a nearby bracket,
/// so that a short list costs little, plus one, so that its end is noticed.
std::size_t most_ahead(const char* p, const char* last) {
    const std::size_t bytes = std::min(static_cast<std::size_t>(last - p), 2 * most_at_once);
    const void* const bracket = std::memchr(p, ']', bytes);
    const std::size_t length =
        bracket ? static_cast<std::size_t>(static_cast<const char*>(bracket) - p) : bytes;
    return (length + 1) / 2 + 1;  // a digit and a blank each
}

/// Reads on all threads up to the end of the text, or to a part that cannot be read in pieces. That
/// part is read again by one thread, which knows where comments begin.
template <class T>
void read_in_pieces(const char*& p, const ListText& text, std::vector<T>& values) {
    const char* next = p;
    std::array<Batch<T>, 2> batches;
    batches[0].take(next, text.last);
    batches[0].read();
    bool goes_on = true;
    for (std::size_t i = 0; goes_on && !batches[i % 2].empty(); ++i) {
        Batch<T>& behind = batches[(i + 1) % 2];
        behind.take(next, text.last);
        parallel_invoke([&] { goes_on = batches[i % 2].append_to(p, text, values); },
                        [&] { behind.read(); });
    }
}

}  // namespace

template <class T>
void read_numbers(const char*& p, const char* last, std::vector<T>& values) {
    const char* const first = p;
    const std::size_t before = values.size();
    bool in_pieces = false;
    while (true) {
        const std::size_t count = values.size();
        const std::size_t most = most_ahead(p, last);
        values.resize(count + most);
        const std::size_t more = read_numbers(p, last, std::span<T>(values).subspan(count));
        values.resize(count + more);
        if (more < most || p == last) return;
        if (values.capacity() - values.size() >= most_at_once) continue;
        const void* const bracket = std::memchr(p, ']', static_cast<std::size_t>(last - p));
        const ListText text{first, bracket ? static_cast<const char*>(bracket) : last, before};
        text.make_room(p, most_at_once, values);
        if (in_pieces || max_threads() == 1) continue;
        in_pieces = true;
        if (static_cast<std::size_t>(text.last - p) >= shortest_shared) {
            read_in_pieces(p, text, values);
        }
    }
}

template void read_numbers(const char*&, const char*, std::vector<float>&);
template void read_numbers(const char*&, const char*, std::vector<double>&);
template void read_numbers(const char*&, const char*, std::vector<std::int32_t>&);

}  // namespace etalon
