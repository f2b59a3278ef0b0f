#include "scenes/generate/scene_output.h"

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "app/common/console.h"

namespace etalon::generate {
namespace {

namespace fs = std::filesystem;

bool is_written_in_place(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
    if (path.empty()) return;
    if (is_written_in_place(path)) {
        device_ = std::fopen(path.c_str(), "wb");
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
    if (!success) throw std::runtime_error(path_ + ": " + std::generic_category().message(errno));
}

}  // namespace etalon::generate
