#include "bench/frames/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace etalon::frames {

ScratchFolder::ScratchFolder() {
    std::error_code error;
    std::string name = std::filesystem::temp_directory_path(error) / "etalon-XXXXXX";
    if (!error && ::mkdtemp(name.data()) == nullptr) error = {errno, std::generic_category()};
    if (error) {
        error_ = "no folder for temporary files: " + error.message();
    } else {
        path_ = name;
    }
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace etalon::frames
