#pragma once

#include <cfenv>

namespace etalon {

/// The floating-point environment a program starts with, for as long as it lives; then the one
/// there was. Embree leaves threads that flush denormals to zero, and what an image looks like
/// must not depend on which thread it was computed on.
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
