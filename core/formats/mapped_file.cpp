#include "core/formats/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/read_log.h"

namespace etalon {
namespace {

#if defined(MAP_POPULATE)
constexpr int mapping = MAP_PRIVATE | MAP_POPULATE;  // all pages at once, as all will be read
#else
constexpr int mapping = MAP_PRIVATE;
#endif

/// Returns the file's pages and sets their size in bytes; nothing if they cannot be mapped.
const char* map(const std::string& path, std::size_t& size) {
    struct stat status {};
    // A pipe that was opened and closed again has lost its writer.
    if (path == "-" || ::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return nullptr;
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return nullptr;
    void* pages = MAP_FAILED;
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0 &&
        static_cast<std::size_t>(status.st_size) <= largest_file) {
        size = static_cast<std::size_t>(status.st_size);
        pages = ::mmap(nullptr, size, PROT_READ, mapping, file, 0);
    }
    ::close(file);
    return pages == MAP_FAILED ? nullptr : static_cast<const char*>(pages);
}

}  // namespace

MappedFile::MappedFile(const std::string& path, FileKind kind) : mapped_(map(path, size_)) {
    if (mapped_) {
        ReadLog::note(path, text());
    } else {
        read_ = read_file(path, kind);
    }
}

MappedFile::~MappedFile() {
    if (mapped_) ::munmap(const_cast<char*>(mapped_), size_);
}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(mapped_, other.mapped_);
    std::swap(size_, other.size_);
    std::swap(read_, other.read_);
    return *this;
}

}  // namespace etalon
