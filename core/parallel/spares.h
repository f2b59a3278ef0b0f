#pragma once

#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace etalon {

/// Objects that are dear to make and are needed for a while by one thread at a time: who is done
/// with one leaves it for the next, unless an exception ends its use, which may have left the
/// object half changed. Thread-safe.
template <class T>
class Spares {
  public:
    /// One of the objects, until it is destroyed.
    class Loan {
      public:
        Loan(Spares& from, std::unique_ptr<T> object) : from_(from), object_(std::move(object)) {}
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;
        ~Loan() {
            if (std::uncaught_exceptions() == exceptions_) from_.take_back(std::move(object_));
        }

        T& operator*() const { return *object_; }

      private:
        Spares& from_;
        std::unique_ptr<T> object_;
        int exceptions_ = std::uncaught_exceptions();
    };

    /// Lends an object, as it was left, or a new one of these arguments.
    template <class... Arguments>
    Loan lend(Arguments&&... arguments) {
        const std::lock_guard lock(mutex_);
        if (spare_.empty()) {
            spare_.reserve(++made_);
            return {*this, std::make_unique<T>(std::forward<Arguments>(arguments)...)};
        }
        std::unique_ptr<T> object = std::move(spare_.back());
        spare_.pop_back();
        return {*this, std::move(object)};
    }

  private:
    /// There is room for all that were made, so this cannot fail.
    void take_back(std::unique_ptr<T> object) noexcept {
        const std::lock_guard lock(mutex_);
        spare_.push_back(std::move(object));
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> spare_;
    std::size_t made_ = 0;
};

}  // namespace etalon
