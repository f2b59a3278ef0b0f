#include "app/live/tev_view.h"

#include <chrono>

#include "app/common/console.h"
#include "app/live/tev_packets.h"
#include "core/image/image.h"

namespace etalon {
namespace {

using namespace std::chrono_literals;

/// Time between two checks for changes.
constexpr auto interval = 100ms;

/// Time for which the finished image waits for a viewer that takes nothing.
constexpr auto patience = 1s;

}  // namespace

TevView::TevView(std::string address, std::string name, const LiveImage& image)
    : address_(std::move(address)),
      name_(std::move(name)),
      image_(image),
      sent_(image.tiles().size(), 0),
      thread_([this] { run(); }) {}

TevView::~TevView() {
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    ending_.notify_all();
    thread_.join();
}

void TevView::run() {
    TcpSender sender([this](TcpSender::Seconds waited) { return !is_over_ || waited < patience; });
    const std::string error = send_all(sender);
    if (error.empty()) return;
    print_message("etalon: warning: tev at {}: {}; rendering goes on without it\n", address_,
                  error);
}

std::string TevView::send_all(TcpSender& sender) {
    std::string error = sender.connect(parse_address(address_));
    const Imath::V2i& size = image_.settings().resolution;
    if (error.empty()) error = sender.send(tev::create_image(name_, size.x, size.y));
    for (bool is_last = false; error.empty() && !is_last;) {
        is_last = is_over_;  // read before the image
        error = send_changes(sender);
        std::unique_lock lock(mutex_);
        if (!is_last) ending_.wait_for(lock, interval, [this] { return is_over_.load(); });
    }
    return error;
}

std::string TevView::send_changes(TcpSender& sender) {
    for (std::size_t tile = 0; tile < sent_.size(); ++tile) {
        const std::uint64_t version = image_.version(tile);  // the copy is as new or newer
        if (version == sent_[tile]) continue;
        std::vector<Color> colors = image_.pixels_of(tile).colors;
        if (image_.settings().decodes()) decode(colors);
        const std::string message = tev::update_image(name_, image_.tiles()[tile], colors);
        if (std::string error = sender.send(message); !error.empty()) return error;
        sent_[tile] = version;
    }
    return {};
}

}  // namespace etalon
