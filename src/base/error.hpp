#pragma once

#include <string>

#include "fingerpad/error.hpp"

namespace fingerpad {

/// An input that cannot be used: exit code 3.
inline Error refused(const std::string& where, const std::string& what) {
  return {ErrorKind::refused, where, what};
}

}  // namespace fingerpad
