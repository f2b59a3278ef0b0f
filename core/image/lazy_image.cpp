#include "core/image/lazy_image.h"

#include "core/image/io.h"

namespace etalon {

void LazyImage::choose(std::string path, Image substitute) {
    path_ = std::move(path);
    image_ = std::move(substitute);
}

std::string LazyImage::problem() const {
    const std::lock_guard lock(mutex_);
    return problem_;
}

/// Readers of files must not wait for tasks of the renderer's threads: such a wait may execute a
/// task that needs this same image.
const CompactImage& LazyImage::read() const {
    const std::lock_guard lock(mutex_);
    if (!ready_.load(std::memory_order_relaxed)) {
        Result<CompactImage> file = read_compact_image(path_);
        if (file) image_ = std::move(file.value);
        problem_ = std::move(file.error);
        ready_.store(&image_, std::memory_order_release);
    }
    return image_;
}

}  // namespace etalon
