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

/// Sends an image to tev while it is rendered. A thread of its own sends the tiles that have
/// changed, each as it then is: a viewer that is slow, hangs or closes holds nobody. Where there is
/// none, or no longer, a warning says so once.
class TevView {
  public:
    /// `name` is what the viewer calls the image. The image must outlive this.
    TevView(std::string address, std::string name, const LiveImage& image);

    /// Sends what has changed, as long as the viewer takes some of it every second.
    ~TevView();

    TevView(const TevView&) = delete;
    TevView& operator=(const TevView&) = delete;

  private:
    void run();
    std::string send_all(TcpSender& sender);
    std::string send_changes(TcpSender& sender);

    std::string address_, name_;
    const LiveImage& image_;
    std::vector<std::uint64_t> sent_;  ///< versions of the tiles
    std::mutex mutex_;
    std::condition_variable ending_;
    std::atomic<bool> is_over_ = false;  ///< no more will change
    std::thread thread_;
};

}  // namespace etalon
