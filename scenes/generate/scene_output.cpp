#include "scenes/generate/scene_output.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "app/common/console.h"
#include "core/base/link_target.h"

namespace etalon::generate {
namespace {

namespace fs = std::filesystem;

bool written_in_place(const std::string& path) {
    std::error_code ignored;
    return path.empty() || (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored));
}

void require(bool success) {
    if (!success) throw std::system_error(errno, std::generic_category());
}

}  // namespace

Output::Output(const std::string& path)
    : path_(link_target(path).string()),
      written_(written_in_place(path_) ? path_ : path_ + ".part"),
      file_(path.empty() ? nullptr : std::fopen(written_.c_str(), "wb")) {
    require(path.empty() || file_ != nullptr);
}

Output::~Output() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    if (written_ != path_) std::remove(written_.c_str());
}

void Output::write(std::string_view text) {
    if (file_ == nullptr) return require(write_result(text));
    require(std::fwrite(text.data(), 1, text.size(), file_) == text.size());
    require(std::fflush(file_) == 0);
}

void Output::commit() {
    if (written_ != path_) require(std::rename(written_.c_str(), path_.c_str()) == 0);
    written_ = path_;
}

}  // namespace etalon::generate
