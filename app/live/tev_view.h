#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/live/live_image.h"
#include "app/live/tcp_sender.h"

namespace etalon {

/// Sends an image to tev during its rendering. A separate thread sends the tiles that have changed,
/// in their current state, so that a viewer that is slow, hangs or closes blocks nothing. If there
/// is no viewer, or no longer, there is one warning.
class TevView {
  public:
    /// `name` is the viewer's name for the image. The image must outlive this.
    TevView(std::string address, std::string name, const LiveImage& image);

    /// Sends the remaining changes, as long as the viewer takes some of them every second.
    ~TevView();

    TevView(const TevView&) = delete;
    TevView& operator=(const TevView&) = delete;

  private:
    void run();
    std::string send_all(TcpSender& sender);
    std::string send_changes(TcpSender& sender);

    std::string address_, name_;
    const LiveImage& image_;
    std::vector<std::uint64_t> sent_;  ///< sent versions of the tiles
    std::mutex mutex_;
    std::condition_variable ending_;
    std::atomic<bool> is_over_ = false;  ///< no more changes will come
    std::thread thread_;
};

}  // namespace etalon
