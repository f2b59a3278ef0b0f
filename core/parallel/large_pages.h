// Memory for random access. In pages of 2 MiB, fewer addresses miss the translation look-aside
// buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace etalon {

inline constexpr std::size_t large_page = 1 << 21;

/// Asks for large pages for those that lie completely in the `bytes` from `memory` on. This is a
/// hint: without them everything works the same, but slower.
inline void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    const std::size_t before = -reinterpret_cast<std::uintptr_t>(memory) % large_page;
    if (bytes < before + large_page) return;
    madvise(static_cast<char*>(memory) + before, (bytes - before) / large_page * large_page,
            MADV_HUGEPAGE);
#endif
}

/// An allocator that asks for large pages where the memory can fill them.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        void* const memory = ::operator new(bytes, alignment(count));
        prefer_large_pages(memory, bytes);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count)); }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }

  private:
    static std::align_val_t alignment(std::size_t count) {
        return std::align_val_t(count * sizeof(T) < large_page ? alignof(T) : large_page);
    }
};

/// A vector that may be long: growing it costs a page fault for each 2 MiB instead of each 4 KiB.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace etalon
