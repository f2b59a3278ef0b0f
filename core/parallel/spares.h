#pragma once

#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace etalon {

/// A pool of objects that are expensive to make and are used by one thread at a time. They are
/// returned to the pool after use, unless an exception ends the use, which may have left the object
/// half changed. Thread-safe.
template <class T>
class Spares {
  public:
    /// A borrowed object, returned by the destructor.
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

    /// Lends an object in the state in which it was returned, or a new one made with these
    /// arguments.
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
    /// There is room for all objects, so this cannot fail.
    void take_back(std::unique_ptr<T> object) noexcept {
        const std::lock_guard lock(mutex_);
        spare_.push_back(std::move(object));
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> spare_;
    std::size_t made_ = 0;
};

}  // namespace etalon
