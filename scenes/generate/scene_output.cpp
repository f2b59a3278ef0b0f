#include "scenes/generate/scene_output.h"

#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "app/common/console.h"
#include "core/base/uninterrupted.h"
#include "core/base/write_target.h"

namespace etalon::generate {
namespace {

/// Opens what is written in place; nullptr if that fails.
std::FILE* open_in_place(const std::string& path, int stream) {
    return stream < 0 ? std::fopen(path.c_str(), "wb") : ::fdopen(::dup(stream), "wb");
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
    if (path.empty()) return;
    const WriteTarget target(path);
    if (target.is_in_place()) {
        device_ = open_in_place(path, target.stream());
        require(device_ != nullptr);
    } else {
        file_.emplace(path);
    }
}

Output::~Output() {
    if (device_ != nullptr) std::fclose(device_);
}

void Output::write(std::string_view text) {
    if (file_) {
        file_->write(text);
        if (file_->has_failed()) commit();
    } else if (device_ != nullptr) {
        require(std::fwrite(text.data(), 1, text.size(), device_) == text.size());
        require(std::fflush(device_) == 0);
    } else {
        require(write_result(text));
    }
}

void Output::commit() {
    if (!file_) return;
    const std::string error = file_->put_in_place();
    if (!error.empty()) throw std::runtime_error(error);
}

void Output::require(bool success) const {
    if (!success) throw std::runtime_error(path_ + ": " + error_text(errno));
}

}  // namespace etalon::generate
