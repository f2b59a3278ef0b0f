#include "tests/app/tev_listener.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <optional>
#include <stdexcept>

namespace etalon::test {
namespace {

constexpr std::size_t largest_message = 1 << 26;

/// Reads so many bytes; fewer only at the end of the connection.
std::string read_bytes(int connection, std::size_t count) {
    std::string bytes(count, '\0');
    std::size_t have = 0;
    while (have < count) {
        const ssize_t n = ::recv(connection, bytes.data() + have, count - have, 0);
        if (n <= 0) break;
        have += static_cast<std::size_t>(n);
    }
    bytes.resize(have);
    return bytes;
}

/// Reads the fields of a message one by one.
class Fields {
  public:
    explicit Fields(std::string bytes) : bytes_(std::move(bytes)) {}

    template <class T>
    T value() {
        T result;
        if (at_ + sizeof result > bytes_.size()) throw std::runtime_error("message too short");
        std::memcpy(&result, bytes_.data() + at_, sizeof result);
        at_ += sizeof result;
        return result;
    }

    std::string text() {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string::npos) throw std::runtime_error("text without an end");
        std::string result = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return result;
    }

    std::vector<std::string> texts(std::int32_t count) {
        std::vector<std::string> result;
        for (std::int32_t i = 0; i < count; ++i) result.push_back(text());
        return result;
    }

    bool at_end() const { return at_ == bytes_.size(); }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

/// Returns the next message without its length; nothing at the end of the connection.
std::optional<Fields> next_message(int connection) {
    const std::string head = read_bytes(connection, 4);
    if (head.empty()) return std::nullopt;
    std::uint32_t length = 0;
    if (head.size() == 4) std::memcpy(&length, head.data(), 4);
    if (length < 5 || length > largest_message) throw std::runtime_error("wrong length");
    std::string rest = read_bytes(connection, length - 4);
    if (rest.size() != length - 4) throw std::runtime_error("message cut short");
    return Fields(std::move(rest));
}

void create(Fields& fields, std::map<std::string, ViewedImage>& images) {
    ViewedImage& image = images[fields.text()];
    image.width = fields.value<std::int32_t>();
    image.height = fields.value<std::int32_t>();
    const std::size_t size = static_cast<std::size_t>(image.width) * image.height;
    for (const std::string& name : fields.texts(fields.value<std::int32_t>())) {
        image.channels[name].assign(size, 0);
    }
}

/// The second version of the operation: several channels, one after the other.
void update(Fields& fields, std::map<std::string, ViewedImage>& images) {
    ViewedImage& image = images.at(fields.text());
    const auto names = fields.texts(fields.value<std::int32_t>());
    const auto x0 = fields.value<std::int32_t>(), y0 = fields.value<std::int32_t>();
    const auto width = fields.value<std::int32_t>(), height = fields.value<std::int32_t>();
    if (x0 < 0 || y0 < 0 || width < 1 || height < 1 || x0 + width > image.width ||
        y0 + height > image.height) {
        throw std::runtime_error("outside of the image");
    }
    for (const std::string& name : names) {
        std::vector<float>& channel = image.channels.at(name);
        for (int y = y0; y < y0 + height; ++y) {
            for (int x = x0; x < x0 + width; ++x) {
                channel[static_cast<std::size_t>(y) * image.width + x] = fields.value<float>();
            }
        }
    }
    ++image.updates;
}

void obey(Fields& fields, std::map<std::string, ViewedImage>& images) {
    const auto operation = fields.value<std::uint8_t>();
    if (fields.value<std::uint8_t>() > 1) throw std::runtime_error("no bool");
    if (operation != 4 && operation != 5) throw std::runtime_error("unknown operation");
    operation == 4 ? create(fields, images) : update(fields, images);
    if (!fields.at_end()) throw std::runtime_error("message too long");
}

}  // namespace

TevListener::TevListener(Manner manner) : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
    ::listen(listener_, 1);
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this, manner] { run(manner); });
}

TevListener::~TevListener() {
    is_over_ = true;
    if (thread_.joinable()) thread_.join();
    ::close(listener_);
}

std::string TevListener::address() const {
    return "127.0.0.1:" + std::to_string(port_);
}

std::map<std::string, ViewedImage> TevListener::images() {
    thread_.join();
    if (!error_.empty()) throw std::runtime_error(error_);
    return images_;
}

void TevListener::run(Manner manner) {
    pollfd state = {listener_, POLLIN, 0};
    while (!is_over_ && ::poll(&state, 1, 20) == 0) continue;
    if (is_over_) return;
    const int connection = ::accept(listener_, nullptr, nullptr);
    try {
        if (manner == Manner::close_after_some) next_message(connection);
        while (manner == Manner::read_all) {
            std::optional<Fields> message = next_message(connection);
            if (!message) break;
            obey(*message, images_);
        }
        while (manner == Manner::read_nothing && !is_over_) ::usleep(10000);
    } catch (const std::exception& error) {
        error_ = error.what();
    }
    ::close(connection);
}

}  // namespace etalon::test
