// Messages between the process that deals tiles, rank 0, and those that render them. The first byte
// is the kind of message. Bytes are in the processors' order, which must be the same.
#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "core/render/state.h"

namespace etalon {

enum class MessageKind : char {
    ready,     ///< to rank 0: the number of threads, and the image's identity as JSON
    failure,   ///< to rank 0: why the sender cannot work
    problem,   ///< to rank 0: why an image was replaced, in tiles whose results follow
    tasks,     ///< from rank 0: tiles to render
    results,   ///< to rank 0: tiles rendered
    end,       ///< from rank 0: there is no more work
    file,      ///< a piece of a file of the scene
    files_end  ///< all files of the scene have been sent
};

inline std::string message_of(MessageKind kind, std::string_view content = {}) {
    return std::string(1, static_cast<char>(kind)).append(content);
}

/// Return the kind and the content of a message.
inline MessageKind kind_of(std::string_view message) {
    return static_cast<MessageKind>(message.front());
}
inline std::string_view content_of(std::string_view message) {
    return message.substr(1);
}

/// Returns a writer that appends to a text.
inline StateWriter writer_to(std::string& text) {
    return StateWriter([&text](std::string_view bytes) { text += bytes; });
}

/// A message of tiles: for each its number, its number of bytes, and the bytes.
class TileMessage {
  public:
    /// Size in bytes from which a message takes no more tiles.
    static constexpr std::size_t full = 1 << 20;

    explicit TileMessage(MessageKind kind) : text_(message_of(kind)) {}

    void add(std::uint64_t tile, std::string_view bytes) {
        StateWriter head = writer_to(text_);
        head(tile);
        head(static_cast<std::uint64_t>(bytes.size()));
        text_ += bytes;
    }

    bool is_empty() const { return text_.size() == 1; }
    bool is_full() const { return text_.size() >= full; }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Returns a reader of bytes, which removes what it reads from their front.
inline StateReader reader_of(std::string_view& bytes) {
    return StateReader([&bytes](char* to, std::size_t size) {
        if (size > bytes.size()) return false;
        std::memcpy(to, bytes.data(), size);
        bytes.remove_prefix(size);
        return true;
    });
}

/// Calls visit(tile, bytes) for the tiles of a message's content. Returns false if it is truncated.
template <class Visit>
bool for_each_tile_of(std::string_view content, const Visit& visit) {
    while (!content.empty()) {
        std::uint64_t tile = 0, size = 0;
        StateReader head = reader_of(content);
        head(tile);
        head(size);
        if (head.failed() || size > content.size()) return false;
        visit(static_cast<std::size_t>(tile), content.substr(0, size));
        content.remove_prefix(size);
    }
    return true;
}

}  // namespace etalon
