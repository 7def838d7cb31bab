#pragma once

#include <stdexcept>
#include <string>

namespace fingerpad::test {

/// What a reader promises of all that it lets through. Not an Error, so that it counts as a finding.
inline void promise(bool kept, const char* what) {
  if (!kept) throw std::logic_error(std::string("broken promise: ") + what);
}

}  // namespace fingerpad::test
