#pragma once

#include <utility>
#include <variant>

namespace etalon {

/// A std::variant that may run out of memory while it is copied. libstdc++ 12 assumes that a
/// variant of vectors and strings always has a value, and destroys one that was not constructed if
/// copying throws. Here the value is copied first, and then moved, which does not throw.
template <class... T>
class CopyableVariant : public std::variant<T...> {
    using Base = std::variant<T...>;

  public:
    using Base::Base;
    using Base::operator=;

    CopyableVariant() = default;
    CopyableVariant(CopyableVariant&&) noexcept = default;
    CopyableVariant& operator=(CopyableVariant&&) noexcept = default;
    ~CopyableVariant() = default;

    CopyableVariant(const CopyableVariant& other) : Base() {
        const auto copy = [this](auto value) { this->Base::operator=(std::move(value)); };
        std::visit(copy, static_cast<const Base&>(other));
    }
    CopyableVariant& operator=(const CopyableVariant& other) {
        return *this = CopyableVariant(other);
    }
};

}  // namespace etalon
