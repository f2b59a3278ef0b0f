#pragma once

#include <new>
#include <type_traits>

namespace etalon {

/// Memory for an object that is made in it if it is needed. Unlike an empty std::optional, of which
/// GCC clears all bytes, it is not initialized.
template <class T>
class LazyStorage {
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    LazyStorage() {}
    LazyStorage(const LazyStorage&) = delete;
    LazyStorage& operator=(const LazyStorage&) = delete;
    ~LazyStorage() = default;

    /// Makes the object, which is the result of make(), in place.
    template <class Make>
    const T& emplace(const Make& make) {
        return *::new (static_cast<void*>(&value_)) T(make());
    }

  private:
    union {
        T value_;
    };
};

}  // namespace etalon
