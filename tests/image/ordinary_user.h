#pragma once

#include <unistd.h>

#include <cstdlib>

namespace etalon::test {

/// Switches root, who may write anywhere, to another user during its lifetime; other users stay.
class OrdinaryUser {
  public:
    OrdinaryUser() : was_root_(::geteuid() == 0) {
        if (was_root_) changed_ = ::setresuid(nobody, nobody, 0) == 0;
    }
    ~OrdinaryUser() {
        if (changed_ && ::setresuid(0, 0, 0) != 0) std::abort();
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

  private:
    static constexpr uid_t nobody = 65534;
    bool was_root_, changed_ = false;
};

}  // namespace etalon::test
