#include "support/effort.hpp"

namespace fingerpad::test {

bool sanitized() noexcept {
#ifdef __SANITIZE_ADDRESS__
  return true;
#else
  return false;
#endif
}

}  // namespace fingerpad::test
