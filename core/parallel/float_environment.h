#pragma once

#include <cfenv>

namespace etalon {

/// Sets the floating-point environment with which a program starts, and restores the previous one
/// at the end of its lifetime. Embree leaves threads that flush denormals to zero, and an image
/// must not depend on the thread that computed it.
class DefaultFloatEnvironment {
  public:
    DefaultFloatEnvironment() {
        std::fegetenv(&before_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultFloatEnvironment() { std::fesetenv(&before_); }
    DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
    DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;

  private:
    std::fenv_t before_;
};

}  // namespace etalon
