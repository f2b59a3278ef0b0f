#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace etalon {

/// Hash in 64 bits of bytes that come in pieces of any size: by 128-bit products of eight bytes and
/// the hash so far. It detects damage and different contents, not forgery.
class Hash64 {
  public:
    void add(std::string_view bytes) {
        if (bytes.empty()) return;  // there may be no address to copy from
        size_ += bytes.size();
        if (held_ > 0) bytes.remove_prefix(hold(bytes));
        for (; bytes.size() >= sizeof word_; bytes.remove_prefix(sizeof word_)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data(), sizeof word);
            mix(word);
        }
        hold(bytes);
    }

    std::uint64_t value() const {
        Hash64 end = *this;
        end.mix(word_);
        end.mix(size_);
        return end.hash_;
    }

  private:
    /// Stores bytes until there are eight. Returns how many it took.
    std::size_t hold(std::string_view bytes) {
        const std::size_t count = std::min(bytes.size(), sizeof word_ - held_);
        std::memcpy(reinterpret_cast<char*>(&word_) + held_, bytes.data(), count);
        held_ += count;
        if (held_ == sizeof word_) {
            mix(word_);
            word_ = held_ = 0;
        }
        return count;
    }

    void mix(std::uint64_t word) {
        __extension__ using Wide = unsigned __int128;
        const Wide product = Wide(hash_ ^ word ^ 0x9e3779b97f4a7c15U) * 0xd6e8feb86659fd93U;
        hash_ = static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64) ^
                (hash_ << 23 | hash_ >> 41);
    }

    std::uint64_t hash_ = 0, word_ = 0, size_ = 0;
    std::size_t held_ = 0;
};

inline std::uint64_t hash64(std::string_view bytes) {
    Hash64 hash;
    hash.add(bytes);
    return hash.value();
}

}  // namespace etalon
