#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "core/image/compact_image.h"

namespace etalon {

/// Image of a file that is read once, when it is first needed. All functions but choose() are
/// thread-safe.
class LazyImage {
  public:
    /// Chooses the file, and the image that replaces it if it cannot be read.
    void choose(std::string path, Image substitute);

    const CompactImage& get() const {
        const CompactImage* ready = ready_.load(std::memory_order_acquire);
        return ready ? *ready : read();
    }

    /// Returns why get() returns the substitute, beginning with the path; empty if it does not.
    std::string problem() const;

  private:
    const CompactImage& read() const;

    std::string path_;
    mutable std::mutex mutex_;
    mutable CompactImage image_;  ///< the substitute until the file has been read
    mutable std::string problem_;
    mutable std::atomic<const CompactImage*> ready_ = nullptr;
};

}  // namespace etalon
