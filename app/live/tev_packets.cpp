#include "app/live/tev_packets.h"

#include "core/numerics/pixel_window.h"

#include <bit>
#include <cstdint>

namespace etalon::tev {
namespace {

enum Operation : std::uint8_t { create = 4, update_channels = 5 };

constexpr const char* channel_names[] = {"R", "G", "B"};

/// A message under construction.
class Packet {
  public:
    /// Begins an operation on an image, which the viewer selects if `select`.
    Packet(Operation operation, bool select, const std::string& image) {
        integer(0);  // placeholder of the length
        bytes_ += static_cast<char>(operation);
        bytes_ += static_cast<char>(select ? 1 : 0);
        text(image);
    }

    void integer(std::uint32_t value) { put(bytes_.size(), value); }
    void number(float value) { integer(std::bit_cast<std::uint32_t>(value)); }

    void text(const std::string& value) {
        bytes_ += value;
        bytes_ += '\0';
    }

    void channels() {
        integer(std::size(channel_names));
        for (const char* name : channel_names) text(name);
    }

    std::string finished() {
        put(0, static_cast<std::uint32_t>(bytes_.size()));
        return std::move(bytes_);
    }

  private:
    void put(std::size_t at, std::uint32_t value) {
        bytes_.resize(std::max(bytes_.size(), at + sizeof value));
        for (std::size_t i = 0; i < sizeof value; ++i) {
            bytes_[at + i] = static_cast<char>(value >> (8 * i));
        }
    }

    std::string bytes_;
};

}  // namespace

std::string create_image(const std::string& name, int width, int height) {
    Packet packet(create, true, name);
    packet.integer(width);
    packet.integer(height);
    packet.channels();
    return packet.finished();
}

std::string update_image(const std::string& name, const Imath::Box2i& part,
                         const std::vector<Color>& colors) {
    Packet packet(update_channels, false, name);
    packet.channels();
    const Imath::V2i size = window_size(part);
    for (const int value : {part.min.x, part.min.y, size.x, size.y}) {
        packet.integer(value);
    }
    for (int channel = 0; channel < 3; ++channel) {
        for (const Color& color : colors) packet.number(color[channel]);
    }
    return packet.finished();
}

}  // namespace etalon::tev
