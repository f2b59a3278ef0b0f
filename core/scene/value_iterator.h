#pragma once

#include <cstddef>

namespace etalon {

/// Iterates over a container that computes its elements on access.
template <class Container>
class ValueIterator {
  public:
    ValueIterator(const Container& container, std::size_t place)
        : container_(&container), place_(place) {}

    auto operator*() const { return (*container_)[place_]; }
    ValueIterator& operator++() { return ++place_, *this; }
    bool operator==(const ValueIterator& other) const { return place_ == other.place_; }

  private:
    const Container* container_;
    std::size_t place_;
};

}  // namespace etalon
