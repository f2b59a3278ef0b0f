// Memory for what is read at random: where a page is 2 MiB, its address is seldom looked up anew.
#pragma once

#include <cstddef>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace etalon {

/// An allocator that asks for large pages where they could be filled. They are a hint: without
/// them all is the same but slower.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        void* const memory = ::operator new(bytes, alignment(count));
#if defined(__linux__)
        if (const std::size_t whole = bytes / page * page) madvise(memory, whole, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        ::operator delete(memory, alignment(count));
    }

    friend bool operator==(const LargePages&, const LargePages&) {
        return true;
    }

  private:
    static constexpr std::size_t page = 1 << 21;

    static std::align_val_t alignment(std::size_t count) {
        return std::align_val_t(count * sizeof(T) < page ? alignof(T) : page);
    }
};

}  // namespace etalon
