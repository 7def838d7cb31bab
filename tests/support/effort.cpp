#include "support/effort.hpp"

namespace fingerpad::test {

bool sanitized() noexcept {
#ifdef FINGERPAD_SANITIZED
  return true;
#else
  return false;
#endif
}

}  // namespace fingerpad::test
