#pragma once

#include <memory>
#include <new>
#include <utility>

namespace etalon {

/// An allocator for elements that are filled later: those without a value are left uninitialized.
/// `Memory` is the allocator that they get their memory from.
template <class T, template <class> class Memory = std::allocator>
struct Uninitialized : Memory<T> {
    template <class U>
    struct rebind {
        using other = Uninitialized<U, Memory>;
    };

    Uninitialized() = default;
    template <class U>
    Uninitialized(const Uninitialized<U, Memory>&) {}

    template <class U>
    void construct(U* element) {
        ::new (static_cast<void*>(element)) U;
    }
    template <class U, class... V>
    void construct(U* element, V&&... values) {
        ::new (static_cast<void*>(element)) U(std::forward<V>(values)...);
    }
};

}  // namespace etalon
